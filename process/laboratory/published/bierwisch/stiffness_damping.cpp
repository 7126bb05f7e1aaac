// What Young's modulus and damping change in the discharge of the shoe, and damping in the angles of repose
// (Bierwisch 2009, sections 4.2.2 and 4.2.3); the source's results are not in the tree, so that the rows have
// no published value. Its softest grains, E~ = 1e5 Pa, are pressed in beyond the method's limit of 0.6 R as
// they fall into the shoe (d = 1.88 mm, after 0.09 s): 1e6 Pa is in their place. Its stiffest, 1e11 Pa, take
// 40 times the steps of the usual ones and are left out of the coarse size.
#include <cmath>

#include "process/laboratory/published/bierwisch/repose_scene.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/run_series.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kModuli[] = {1e6, 1e7, 1e9, 1e11};       // Pa, E~
constexpr double kStiffestCoarse = 1e9;                   // Pa
constexpr double kDampings[] = {1e4, 1e5, 1e6, 1e7};      // Pa s/m, gamma_n / R
constexpr double kDampedHeaps[] = {1e5, 1e6, 1e7};        // Pa s/m
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

std::vector<Case> modulus_cases(LabSize size) {
  std::vector<Case> cases;
  for (const double modulus : kModuli) {
    if (size == LabSize::coarse && modulus > kStiffestCoarse) continue;
    cases.push_back(
        {modulus,
         "E = " + plain(modulus) + " Pa",
         "E~ = " + plain(1e-6 * modulus) + " MPa",
         "ASC100.29 initial D",
         "powder.friction = 0.5\npowder.work_of_adhesion = \"0 J/m^2\"\npowder.reduced_modulus = \"" +
             plain(modulus) + " Pa\"\n",
         {.width = 0.006, .speed = 0.6},
         kUsualStep * std::min(1.0, std::pow(modulus / kUsualModulus, -0.4))});
  }
  return cases;
}

std::string damping_keys(double damping) {
  return line("powder.damping_over_radius", with_unit(damping, "Pa s/m"));
}

std::vector<Case> damping_cases() {
  std::vector<Case> cases;
  for (const double damping : kDampings)
    cases.push_back({damping,
                     "damping over R = " + plain(damping) + " Pa s per m",
                     "gamma_n/R = " + plain(damping) + " Pa s/m",
                     "ASC100.29 D2",
                     damping_keys(damping),
                     {.width = 0.010, .speed = 0.18},
                     step_of_damping(damping)});
  return cases;
}

double settled_fraction(const SeedResults& seed, const std::string& run) {
  return results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
}

/// With the case's parameter, and its step (s, at the published grain size) in place of the usual one.
SceneChanges with_parameter(SceneChanges changes, const LabPowder& powder, const std::string& set,
                            double step) {
  changes.set += set;
  const std::string usual =
      line("numerics.time_step", with_unit(1e6 * kUsualStep * powder.size / powder.own_size, "us"));
  if (const auto at = changes.set.find(usual); at != std::string::npos)
    changes.set.replace(
        at, usual.size(),
        line("numerics.time_step", with_unit(1e6 * step * powder.size / powder.own_size, "us")));
  return changes;
}

void add_case(const LabSetting& setting, const Case& one, LabPlan& plan) {
  const LabPowder powder = lab_powder(setting, one.preset, setting.scale());
  SlitPassage passage = one.passage;
  passage.width = adjusted_slit(passage.width, powder);
  const std::string run = one.name;
  plan.runs.push_back(
      {run, "slit.toml", with_parameter(slit_changes(setting, powder, passage), powder, one.set, one.step)});
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
  plan.quantities.push_back(
      {.id = "grains, " + run,
       .quantity = "grains of the published size discharged, " + one.quantity,
       .unit = "1",
       .runs = {run},
       .value = [=](const SeedResults& seed) { return published_grains(seed, run, powder); }});
}

/// Both heaps of D2 with each damping (Table 4.9).
std::vector<PointOfRun> add_damped_heaps(const LabSetting& setting, LabPlan& plan) {
  const LabPowder powder = lab_powder(setting, "ASC100.29 D2", setting.scale());
  std::vector<PointOfRun> points;
  for (const double damping : kDampedHeaps) {
    const std::string run = "heaps, damping over R = " + plain(damping) + " Pa s per m";
    plan.runs.push_back({run, "repose.toml",
                         with_parameter(repose_changes(setting, powder), powder, damping_keys(damping),
                                        step_of_damping(damping))});
    for (const char* heap : {kHeapOnSlider, kHeapOnFloor}) {
      plan.quantities.push_back(heap_angle(run, heap));
      plan.quantities.back().quantity =
          "angle of repose, " + std::string(heap) + ", gamma_n/R = " + plain(damping) + " Pa s/m";
    }
    points.push_back({damping, run});
  }
  return points;
}

results::ExperimentChart damped_heaps_chart(const std::vector<PointOfRun>& runs, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "damped_heaps";
  chart.title = "Angles of repose over damping";
  chart.subtitle = "Model D2";
  chart.x = {.label = "Damping over radius [Pa s/m]", .logarithmic = true};
  chart.y = {.label = "Angle [deg]", .lower = 0};
  for (const char* heap : {kHeapOnSlider, kHeapOnFloor})
    add_run_series(chart, seed, heap, runs,
                   [&](const std::string& run) { return heap_angle(run, heap).value(seed); });
  return chart;
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
  return plan_of(setting, modulus_cases(setting.size), "Reduced modulus [Pa]");
}

LabPlan plan_damping(const LabSetting& setting) {
  LabPlan plan = plan_of(setting, damping_cases(), "Damping over radius [Pa s/m]");
  const auto heaps = add_damped_heaps(setting, plan);
  plan.charts = [heaps, slit_charts = plan.charts](const SeedResults& seed) {
    auto charts = slit_charts(seed);
    charts.push_back(damped_heaps_chart(heaps, seed));
    return charts;
  };
  return plan;
}

}  // namespace diefill::process::laboratory
