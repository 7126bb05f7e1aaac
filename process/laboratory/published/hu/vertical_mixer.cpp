// Speeds of wet and of adhesive spheres in a vertical mixer at 300 rpm (Hu 2024, section 4.3 and appendix):
// probability density of the speed over liquid, attraction, method of scaling and enlargement. Vessel and
// impeller are assumptions (laboratory.scad). Coarse: l = 8 compared with l = 16, 1 s of rotation; medium:
// l = 4 and 8; published: l = 1 and 4, 3 s.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/hu/speed_density.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kDiameter = 5e-4;                                       // m, original
constexpr double kTipSpeed = 300.0 / 60 * 2 * std::numbers::pi * 0.041;  // m/s
constexpr double kTensions[] = {0, 0.05, 0.1, 0.2, 0.4};                 // N/m
constexpr double kLiquid = 0.05, kLittleLiquid = 0.005;                  // over solid volume
constexpr double kAdhesion = 0.4;                                        // J/m^2, JKR

struct Case {
  bool wet;
  double strength;  ///< N/m of the liquid, or J/m^2
  double liquid;
  int method;
  double enlargement;
};

struct Plan {
  double reference, enlarged;  ///< l
  double rotation, sampled;    ///< s
};

Plan plan_of(LabSize size) {
  if (size == LabSize::coarse) return {8, 16, 1, 0.4};
  return size == LabSize::medium ? Plan{4, 8, 2, 0.6} : Plan{1, 4, 3, 1};
}

std::string name_of(const Case& one) {
  std::string name =
      one.wet ? "wet, " + plain(one.strength) + " N per m" : "JKR, " + plain(one.strength) + " J per m2";
  if (one.liquid != kLiquid) name += ", liquid " + plain(one.liquid);
  return name + ", method " + std::to_string(one.method) + ", l = " + plain(one.enlargement);
}

std::string contact_lines(const Case& one) {
  const std::string adhesion =
      "{ law = \"JKR\", modulus = \"54.9451 MPa\", surface_energy = \"" + plain(one.strength) + " J/m^2\" }";
  std::string set =
      line("contact.coarse_graining", "\"Hu chapter 4 method " + std::to_string(one.method) + '"');
  if (!one.wet) set += line("contact.normal", adhesion);
  if (one.wet && one.strength > 0)
    set += line("contact.attraction", "{ law = \"capillary\", surface_tension = \"" + plain(one.strength) +
                                          " N/m\", liquid_fraction = " + plain(one.liquid) + " }");
  return set;
}

LabRun vertical_mixer_run(const Case& one, const Plan& plan) {
  LabRun run{name_of(one), "mixer.toml", {contact_lines(one), {}}};
  run.changes.set += line("powder.grain_diameter", millimetres(kDiameter * one.enlargement));
  run.changes.set += line("step.mix.duration", with_unit(plan.rotation, "s"));
  return run;
}

SpeedDensity density_of(const SeedResults& seed, const Case& one, const Plan& plan) {
  const results::FillResult& result = seed.of(name_of(one));
  double start = 0;
  for (const auto& stage : result.stages)
    if (stage.tool == "impeller") start = stage.start;
  // The impeller brakes within the last 20 ms.
  return speed_density(result, start + plan.rotation - 0.02, plan.sampled);
}

Case wet(double tension, double l, int method = 1, double liquid = kLiquid) {
  return {true, tension, liquid, method, l};
}

Case adhesive(double l, int method = 1) {
  return {false, kAdhesion, kLiquid, method, l};
}

LabQuantity quantity(const std::string& id, const std::string& label, const std::vector<Case>& cases,
                     const std::function<double(const SeedResults&)>& value) {
  LabQuantity quantity{.id = id, .quantity = label, .unit = "", .runs = {}, .value = value};
  for (const Case& one : cases) quantity.runs.push_back(name_of(one));
  return quantity;
}

void add_liquid(const Plan& plan, LabPlan& lab) {
  const double l = plan.reference;
  lab.quantities.push_back(quantity("MIX-peak", "", {wet(0.05, l)}, [=](const SeedResults& seed) {
    return density_of(seed, wet(0.05, l), plan).peak();
  }));
  std::vector<Case> tensions;
  for (const double tension : kTensions) tensions.push_back(wet(tension, l));
  lab.quantities.push_back(quantity("MIX-shift", "", tensions, [=](const SeedResults& seed) {
    double rising = 0;
    for (std::size_t k = 1; k < tensions.size(); ++k)
      rising +=
          density_of(seed, tensions[k], plan).mean > density_of(seed, tensions[k - 1], plan).mean ? 1 : 0;
    return rising / static_cast<double>(tensions.size() - 1);
  }));
  lab.quantities.push_back(quantity("MIX-lin", "", {tensions.back()}, [=](const SeedResults& seed) {
    return density_of(seed, tensions.back(), plan).linearity(0.8 * kTipSpeed);
  }));
  const Case much = wet(0.05, l), little = wet(0.05, l, 1, kLittleLiquid);
  lab.quantities.push_back(quantity("MIX-liq", "", {much, little}, [=](const SeedResults& seed) {
    return density_of(seed, much, plan).mean - density_of(seed, little, plan).mean;
  }));
}

void add_scaling(const Plan& plan, LabPlan& lab) {
  const double fine = plan.reference, l = plan.enlarged;
  lab.quantities.push_back(
      quantity("MIX-M1", "larger deviation at 0.05 and 0.2 N/m, l = " + plain(l) + " from l = " + plain(fine),
               {wet(0.05, fine), wet(0.2, fine), wet(0.05, l), wet(0.2, l)}, [=](const SeedResults& seed) {
                 const auto apart = [&](double tension) {
                   return percent_apart(density_of(seed, wet(tension, l), plan).mean,
                                        density_of(seed, wet(tension, fine), plan).mean);
                 };
                 return std::max(apart(0.05), apart(0.2));
               }));
  for (const int method : {2, 3})
    lab.quantities.push_back(quantity("MIX-M" + std::to_string(method), "",
                                      {wet(0.2, l), wet(0.2, l, method)}, [=](const SeedResults& seed) {
                                        return density_of(seed, wet(0.2, l, method), plan).peak() -
                                               density_of(seed, wet(0.2, l), plan).peak();
                                      }));
  const auto apart = [=](const SeedResults& seed, int method) {
    return difference(density_of(seed, adhesive(l, method), plan), density_of(seed, adhesive(fine), plan));
  };
  const std::vector<Case> adhesives = {adhesive(fine), adhesive(l), adhesive(l, 2), adhesive(l, 3)};
  lab.quantities.push_back(quantity("MIX-jkr1", "", adhesives, [=](const SeedResults& seed) {
    return apart(seed, 1) - std::min(apart(seed, 2), apart(seed, 3));
  }));
  lab.quantities.push_back(quantity("MIX-jkr23", "", adhesives, [=](const SeedResults& seed) {
    return std::min(apart(seed, 2), apart(seed, 3)) / apart(seed, 1);
  }));
  lab.quantities.push_back(
      quantity("MIX-Dd", "", {wet(0.05, 8), wet(0.05, 16)}, [=](const SeedResults& seed) {
        return density_of(seed, wet(0.05, 16), plan).peak() - density_of(seed, wet(0.05, 8), plan).peak();
      }));
}

std::vector<Case> cases_of(const Plan& plan) {
  const double fine = plan.reference, l = plan.enlarged;
  std::vector<Case> cases;
  for (const double tension : kTensions) cases.push_back(wet(tension, fine));
  cases.push_back(wet(0.05, fine, 1, kLittleLiquid));
  for (const double tension : {0.05, 0.2}) cases.push_back(wet(tension, l));
  for (const int method : {2, 3}) cases.push_back(wet(0.2, l, method));
  cases.push_back(adhesive(fine));
  for (const int method : {1, 2, 3}) cases.push_back(adhesive(l, method));
  for (const double limit : {8.0, 16.0})
    if (fine != limit && l != limit) cases.push_back(wet(0.05, limit));
  return cases;
}

results::ExperimentChart vertical_mixer_chart(const std::string& name, const std::string& subtitle,
                                              const std::vector<Case>& cases, const Plan& plan,
                                              const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = name;
  chart.title = "Speeds of spheres in a vertical mixer at 300 rpm";
  chart.subtitle = subtitle;
  chart.x = {.label = "Speed [m/s]", .lower = 0, .upper = 1.5};
  chart.y = {.label = "Probability density [s/m]", .lower = 0};
  for (const Case& one : cases) {
    if (!seed.has(name_of(one))) continue;
    const SpeedDensity density = density_of(seed, one, plan);
    chart.series.push_back({.name = name_of(one), .x = density.speed, .y = density.density});
  }
  return chart;
}

std::vector<results::ExperimentChart> charts_of(const Plan& plan, const SeedResults& seed) {
  std::vector<Case> liquid, methods, adhesives;
  for (const double tension : kTensions) liquid.push_back(wet(tension, plan.reference));
  liquid.push_back(wet(0.05, plan.reference, 1, kLittleLiquid));
  methods = {wet(0.2, plan.reference), wet(0.2, plan.enlarged), wet(0.2, plan.enlarged, 2),
             wet(0.2, plan.enlarged, 3)};
  adhesives = {adhesive(plan.reference), adhesive(plan.enlarged), adhesive(plan.enlarged, 2),
               adhesive(plan.enlarged, 3)};
  return {vertical_mixer_chart(
              "mixer_liquid",
              "Surface tension and liquid; published: shifts right, peak near 0.75 m/s at 0.05 N/m", liquid,
              plan, seed),
          vertical_mixer_chart("mixer_methods",
                               "Published: method 1 as the original, method 2 slower, method 3 faster",
                               methods, plan, seed),
          vertical_mixer_chart("mixer_adhesion", "JKR; published: method 1 is the nearest to the original",
                               adhesives, plan, seed)};
}

}  // namespace

LabPlan plan_vertical_mixer(const LabSetting& setting) {
  const Plan plan = plan_of(setting.size);
  LabPlan lab;
  const auto cases = cases_of(plan);
  for (const Case& one : cases) lab.runs.push_back(vertical_mixer_run(one, plan));
  add_liquid(plan, lab);
  add_scaling(plan, lab);
  for (const Case& one : cases) {
    const std::string run = name_of(one);
    lab.quantities.push_back(
        {.id = "mean speed, " + run,
         .quantity = "mean speed, " + run,
         .unit = "m/s",
         .runs = {run},
         .value = [=](const SeedResults& seed) { return density_of(seed, one, plan).mean; }});
    lab.quantities.push_back(
        {.id = "peak, " + run,
         .quantity = "most frequent speed, " + run,
         .unit = "m/s",
         .runs = {run},
         .value = [=](const SeedResults& seed) { return density_of(seed, one, plan).peak(); }});
  }
  lab.charts = [plan](const SeedResults& seed) { return charts_of(plan, seed); };
  return lab;
}

}  // namespace diefill::process::laboratory
