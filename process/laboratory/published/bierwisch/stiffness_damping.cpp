// What Young's modulus and damping change in the discharge of the shoe (Bierwisch 2009, sections 4.2.2 and
// 4.2.3); the source's results are not in the tree, so that the rows have no published value. Its softest
// grains, E~ = 1e5 Pa, are pressed in beyond the method's limit of 0.6 R as they fall into the shoe (d = 1.88
// mm, after 0.09 s): 1e6 Pa is in their place.
#include <cmath>

#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kModuli[] = {1e6, 1e7, 1e9};             // Pa, E~
constexpr double kDampings[] = {1e4, 1e5, 1e6, 1e7};      // Pa s/m, gamma_n / R
constexpr double kUsualModulus = 1e7, kUsualStep = 2e-6;  // Pa, s
/// s at the published grain size: at gamma_n/R = 1e7 the dashpot limits the step.
double step_of_damping(double damping) {
  return damping > 5e6 ? 0.1 * kUsualStep : kUsualStep;
}

/// One run: a preset with one parameter changed.
struct Case {
  double value;  ///< of the parameter
  std::string name, quantity;
  const char* preset;
  std::string set;
  SlitPassage passage;
  double step;  ///< s, at the published grain size
};

std::vector<Case> modulus_cases() {
  std::vector<Case> cases;
  for (const double modulus : kModuli)
    cases.push_back(
        {modulus,
         "E = " + plain(modulus) + " Pa",
         "E~ = " + plain(1e-6 * modulus) + " MPa",
         "ASC100.29 initial D",
         "powder.friction = 0.5\npowder.work_of_adhesion = \"0 J/m^2\"\npowder.reduced_modulus = \"" +
             plain(modulus) + " Pa\"\n",
         {.width = 0.006, .speed = 0.6},
         kUsualStep * std::min(1.0, std::pow(modulus / kUsualModulus, -0.4))});
  return cases;
}

std::vector<Case> damping_cases() {
  std::vector<Case> cases;
  for (const double damping : kDampings)
    cases.push_back({damping,
                     "damping over R = " + plain(damping) + " Pa s per m",
                     "gamma_n/R = " + plain(damping) + " Pa s/m",
                     "ASC100.29 D2",
                     "powder.damping_over_radius = \"" + plain(damping) + " Pa s/m\"\n",
                     {.width = 0.010, .speed = 0.18},
                     step_of_damping(damping)});
  return cases;
}

double settled_fraction(const SeedResults& seed, const std::string& run) {
  return results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
}

void add_case(const LabSetting& setting, const Case& one, LabPlan& plan) {
  const LabPowder powder = lab_powder(setting, one.preset, setting.scale());
  SlitPassage passage = one.passage;
  passage.width = adjusted_slit(passage.width, powder);
  SceneChanges changes = slit_changes(setting, powder, passage);
  changes.set += one.set;
  const std::string usual =
      line("numerics.time_step", with_unit(1e6 * kUsualStep * powder.size / powder.own_size, "us"));
  if (const auto at = changes.set.find(usual); at != std::string::npos)
    changes.set.replace(
        at, usual.size(),
        line("numerics.time_step", with_unit(1e6 * one.step * powder.size / powder.own_size, "us")));
  const std::string run = one.name;
  plan.runs.push_back({run, "slit.toml", changes});
  plan.quantities.push_back(
      {.id = "fraction, " + run,
       .quantity = "solid fraction settled, " + one.quantity,
       .unit = "1",
       .runs = {run},
       .value = [run](const SeedResults& seed) { return settled_fraction(seed, run); }});
  plan.quantities.push_back(
      {.id = "area, " + run,
       .quantity = "discharged area, " + one.quantity,
       .unit = "mm^2",
       .runs = {run},
       .value = [run](const SeedResults& seed) { return 1e6 * discharged_area(seed, run); }});
}

results::ExperimentChart stiffness_damping_chart(const std::string& parameter,
                                                 const std::vector<PointOfRun>& runs, bool areas,
                                                 const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = areas ? "discharged_area" : "settled_fraction";
  chart.title = areas ? "Discharged area" : "Solid fraction of the settled powder";
  chart.subtitle = "One passage; the slit is widened for coarse grains";
  chart.x = {.label = parameter, .logarithmic = true};
  chart.y = {.label = areas ? "Discharged area [mm2]" : "Solid fraction [-]", .lower = 0};
  add_run_series(chart, seed, "model D", runs, [&](const std::string& run) {
    return areas ? 1e6 * discharged_area(seed, run) : settled_fraction(seed, run);
  });
  return chart;
}

/// `parameter`: the axis' label.
LabPlan plan_of(const LabSetting& setting, const std::vector<Case>& cases, const std::string& parameter) {
  LabPlan plan;
  std::vector<PointOfRun> points;
  for (const Case& one : cases) {
    add_case(setting, one, plan);
    points.push_back({one.value, one.name});
  }
  plan.charts = [=](const SeedResults& seed) {
    return std::vector{stiffness_damping_chart(parameter, points, true, seed),
                       stiffness_damping_chart(parameter, points, false, seed)};
  };
  return plan;
}

}  // namespace

LabPlan plan_youngs_modulus(const LabSetting& setting) {
  return plan_of(setting, modulus_cases(), "Reduced modulus [Pa]");
}

LabPlan plan_damping(const LabSetting& setting) {
  return plan_of(setting, damping_cases(), "Damping over radius [Pa s/m]");
}

}  // namespace diefill::process::laboratory
