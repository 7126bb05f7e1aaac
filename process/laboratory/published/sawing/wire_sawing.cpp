// Wire sawing (Bierwisch 2009, appendix A). No scene has a fluid of particles: quantities are measured in
// runs of the experiment's own, in reduced units.
#include "process/laboratory/published/sawing/wire_sawing.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/sawing/groove.h"
#include "process/laboratory/published/sawing/groove_charts.h"
#include "process/laboratory/published/sawing/sawing_json.h"
#include "process/laboratory/published/sawing/viscosity.h"

namespace diefill::process::laboratory {
namespace {

using namespace sawing;

/// How much of the published experiment each size does.
struct Extent {
  std::vector<double> rates;                                   ///< of the fluid
  double fluid_edge, slurry_edge, drag_length, groove_length;  ///< r_c
  double longer;                                               ///< of all times
};

Extent extent_of(LabSize size) {
  switch (size) {
    case LabSize::coarse:
      return {{0.1, 0.2}, 8, 10, 4, 6, 1};
    case LabSize::medium:
      return {{0.05, 0.1, 0.2}, 10, 20, 12, 12, 3};
    case LabSize::published:
      break;
  }
  return {{0.02, 0.05, 0.1, 0.2}, 10, 30, 20, 20, 10};
}

int steps(double count, const Extent& extent) {
  return static_cast<int>(std::lround(count * extent.longer));
}

constexpr double kSlurryRates[] = {0.1, 0.2};

/// Noise between fluid and solids over that within the fluid: with less the fluid slips along wire and ingot,
/// which it does not in the source (README.md).
constexpr double kGrip = 4;

/// Runs of one kind, and the shear rate of each.
struct RunsAtRates {
  std::vector<double> rates;
  std::vector<std::string> names;
};

template <class Case>
CustomRun custom_run(const std::string& name, const Case& one) {
  return {name, settings_text(one), work_of(one), [one](std::uint64_t seed, CustomRunWatch& watch) {
            if constexpr (std::is_same_v<Case, GrooveCase>)
              return text_of(saw(one, seed, watch));
            else
              return text_of(measure(one, seed, watch));
          }};
}

/// The smaller the stress, the more of its scatter is averaged.
ShearedSlurry sheared_fluid(double rate, const Extent& extent) {
  constexpr double kAtOne = 300;  // steps, over the square of the rate
  return {.edge = extent.fluid_edge,
          .rate = rate,
          .settling = 1000,
          .sampled = steps(std::min(200000.0, kAtOne / (rate * rate)), extent)};
}

ShearedSlurry sheared_slurry(double rate, const Extent& extent) {
  return {.edge = extent.slurry_edge,
          .rate = rate,
          .solids = 0.25,
          .grip = kGrip,
          .settling = 1000,
          .sampled = steps(4000, extent)};
}

RunsAtRates add_sheared(const std::string& kind, const std::vector<double>& rates, const Extent& extent,
                        ShearedSlurry (*slurry)(double, const Extent&), LabPlan& plan) {
  RunsAtRates added{rates, {}};
  for (const double rate : rates) {
    added.names.push_back("sheared_" + kind + '_' + plain(rate));
    plan.custom_runs.push_back(custom_run(added.names.back(), slurry(rate, extent)));
  }
  return added;
}

/// Viscosity at several shear rates.
using Viscosities = std::vector<ShearedFigures>;

Viscosities viscosities(const RunsAtRates& runs, const SeedResults& seed) {
  Viscosities all;
  for (const std::string& name : runs.names) all.push_back(sheared_figures(seed.own(name)));
  return all;
}

double mean_viscosity(const Viscosities& all) {
  double sum = 0;
  for (const auto& one : all) sum += one.viscosity / static_cast<double>(all.size());
  return sum;
}

double largest_difference(const Viscosities& all) {
  const double mean = mean_viscosity(all);
  double most = 0;
  for (const auto& one : all) most = std::max(most, std::abs(one.viscosity - mean) / mean);
  return most;
}

constexpr double kSpeedOfProcess = 17, kSpeed = 131 / ReducedUnits::velocity;  // m/s, reduced (OP-17)

/// Speeds (m/s) and pressures (N/mm^2) of the process.
struct SawingCase {
  const char* name;
  double speed, pressure;
};
constexpr SawingCase kCases[] = {{"17 m/s, 0.15 N/mm2", 17, 0.15},
                                 {"4.25 m/s, 1.5 N/mm2", 4.25, 1.5},
                                 {"17 m/s, 1.5 N/mm2", 17, 1.5},
                                 {"4.25 m/s, 0.15 N/mm2", 4.25, 0.15}};

constexpr std::size_t kNonContact = 0, kSemiContact = 1;  // of kCases
constexpr const char *kAtRest = "fluid_at_rest", *kDrag = "drag";

std::string groove_name(std::size_t k) {
  return "groove_" + std::to_string(k + 1);
}

GrooveCase drag(const Extent& extent) {
  return {.length = extent.drag_length,
          .speed = kSpeed,
          .grip = kGrip,
          .settling = steps(2500, extent),
          .sampled = steps(3500, extent)};
}

GrooveCase sawing_case(std::size_t k, const Extent& extent) {
  constexpr int kInstants = 60;
  return {.length = extent.groove_length,
          .speed = kSpeed * kCases[k].speed / kSpeedOfProcess,
          .pressure = kCases[k].pressure / ReducedUnits::pressure_of_process,
          .solids = 0.25,
          .grip = kGrip,
          .settling = steps(5000, extent),
          .sampled = steps(3000, extent),
          .instants = k == kNonContact || k == kSemiContact ? kInstants : 0};
}

/// All runs of the experiment.
struct SawingRuns {
  SawingRuns(const Extent& extent, LabPlan& plan) {
    fluid = add_sheared("fluid", extent.rates, extent, sheared_fluid, plan);
    slurry = add_sheared("slurry", {std::begin(kSlurryRates), std::end(kSlurryRates)}, extent, sheared_slurry,
                         plan);
    const ShearedSlurry at_rest{.edge = extent.fluid_edge, .rate = 0, .sampled = steps(2000, extent)};
    plan.custom_runs.push_back(custom_run(kAtRest, at_rest));
    plan.custom_runs.push_back(custom_run(kDrag, drag(extent)));
    for (std::size_t k = 0; k < std::size(kCases); ++k)
      plan.custom_runs.push_back(custom_run(groove_name(k), sawing_case(k, extent)));
  }
  RunsAtRates fluid, slurry;
};

using ValueOf = std::function<double(const SeedResults& seed)>;

/// A quantity; without name and unit those of the published figure.
void add(LabPlan& plan, const std::string& id, std::vector<std::string> runs, const ValueOf& value,
         const std::string& quantity = "", const std::string& unit = "1") {
  plan.quantities.push_back({.id = id,
                             .quantity = quantity,
                             .unit = quantity.empty() ? "" : unit,
                             .runs = std::move(runs),
                             .value = value});
}

/// Reynolds number (Eq. A.6): speed (m/s), gap (m), density (kg/m^3), viscosity (Pa s).
double reynolds(double speed, double gap, double density, double viscosity) {
  return speed * gap * density / viscosity;
}

void add_formulas(LabPlan& plan) {
  add(plan, "Z06", {}, [](const SeedResults&) { return reynolds(17, 20e-6, 1700, 0.2); });
  add(plan, "Z07", {}, [](const SeedResults&) { return reynolds(122, 4.4e-9, 1700, 0.34e-3); });
}

void add_viscosities(const SawingRuns& runs, LabPlan& plan) {
  const RunsAtRates fluid = runs.fluid, slurry = runs.slurry;
  std::vector<std::string> both = fluid.names;
  both.insert(both.end(), slurry.names.begin(), slurry.names.end());
  add(plan, "Z01", slurry.names, [=](const SeedResults& seed) {
    return ReducedUnits::viscosity * mean_viscosity(viscosities(slurry, seed));
  });
  add(plan, "Z02", both, [=](const SeedResults& seed) {
    return mean_viscosity(viscosities(slurry, seed)) / mean_viscosity(viscosities(fluid, seed));
  });
  add(plan, "Z03", fluid.names, [=](const SeedResults& seed) {
    return ReducedUnits::viscosity * mean_viscosity(viscosities(fluid, seed));
  });
  add(plan, "Z04", fluid.names,
      [=](const SeedResults& seed) { return largest_difference(viscosities(fluid, seed)); });
  add(
      plan, "SAW-temperature", {kAtRest},
      [](const SeedResults& seed) { return sheared_figures(seed.own(kAtRest)).temperature; },
      "temperature of the fluid at rest over the one asked for");
  add(
      plan, "SAW-pressure", {kAtRest},
      [](const SeedResults& seed) { return sheared_figures(seed.own(kAtRest)).pressure; },
      "pressure of the fluid at rest at density 4.15, reduced");
  add(
      plan, "SAW-solids", slurry.names,
      [=](const SeedResults& seed) { return viscosities(slurry, seed).front().solids; },
      "share of solids in the slurry of the viscosity");
}

/// The fluid's speed in the gap.
std::vector<GapSpeed> gap_of(const SeedResults& seed) {
  return groove_figures(seed.own(kDrag)).gap;
}

void add_drag(LabPlan& plan) {
  add(plan, "Z05", {kDrag}, [](const SeedResults& seed) { return line_through(gap_of(seed)).r_squared; });
  add(
      plan, "SAW-slip-wire", {kDrag},
      [](const SeedResults& seed) {
        return std::abs(1 - speed_at(gap_of(seed), GrooveCase().wire_radius) / kSpeed);
      },
      "slip of the fluid at the wire over its speed");
  add(
      plan, "SAW-slip-ingot", {kDrag},
      [](const SeedResults& seed) {
        return std::abs(speed_at(gap_of(seed), GrooveCase().groove_radius) / kSpeed);
      },
      "slip of the fluid at the ingot over the speed of the wire");
}

GrooveFigures groove_of(const SeedResults& seed, std::size_t k) {
  return groove_figures(seed.own(groove_name(k)));
}

/// A figure of the run in semi-contact over that of the one without.
void add_ratio(const std::string& id, double (*figure)(const GrooveFigures&), LabPlan& plan) {
  add(plan, id, {groove_name(kNonContact), groove_name(kSemiContact)}, [=](const SeedResults& seed) {
    return figure(groove_of(seed, kSemiContact)) / figure(groove_of(seed, kNonContact));
  });
}

/// Shares of the grains of one size in the source's two upper classes of stress.
void add_grain_classes(LabPlan& plan, std::size_t k, std::size_t size) {
  const double diameter = SlurryMixture().sizes[size];
  const std::string id = "SAW-grains-" + std::to_string(k + 1) + '-' + std::to_string(size + 1);
  const std::string grains = "grains of " + plain(ReducedUnits::micrometres * diameter) + " um under ";
  add(
      plan, id, {groove_name(k)},
      [=](const SeedResults& seed) { return grains_of(groove_of(seed, k), diameter).high; },
      grains + "more than 25 N/mm2, " + kCases[k].name);
  add(
      plan, id + "-middle", {groove_name(k)},
      [=](const SeedResults& seed) { return grains_of(groove_of(seed, k), diameter).middle; },
      grains + "5 to 25 N/mm2, " + kCases[k].name);
}

void add_sawing(LabPlan& plan) {
  add_ratio("Z08", share_at_centre, plan);
  add_ratio("Z09", stress_at_sides, plan);
  for (std::size_t k = 0; k < std::size(kCases); ++k) {
    add(
        plan, "SAW-distance-" + std::to_string(k + 1), {groove_name(k)},
        [=](const SeedResults& seed) { return ReducedUnits::micrometres * groove_of(seed, k).mean_distance; },
        std::string("wire to ingot, ") + kCases[k].name, "um");
    add(
        plan, "SAW-change-" + std::to_string(k + 1), {groove_name(k)},
        [=](const SeedResults& seed) { return ReducedUnits::micrometres * late_change(groove_of(seed, k)); },
        std::string("change of that distance in the last third of the run, ") + kCases[k].name, "um");
  }
  for (const std::size_t k : {kNonContact, kSemiContact})
    for (std::size_t size = 0; size < SlurryMixture().sizes.size(); ++size) add_grain_classes(plan, k, size);
}

/// Figures at the rates whose run is finished.
ViscosityCurve curve_of(const RunsAtRates& runs, const SeedResults& seed) {
  ViscosityCurve curve;
  for (std::size_t k = 0; k < runs.names.size(); ++k) {
    if (!seed.has(runs.names[k])) continue;
    curve.rates.push_back(runs.rates[k]);
    curve.figures.push_back(sheared_figures(seed.own(runs.names[k])));
  }
  return curve;
}

std::vector<results::ExperimentChart> charts_of(const SawingRuns& runs, const SeedResults& seed) {
  std::vector<results::ExperimentChart> charts = {
      viscosity_chart(curve_of(runs.fluid, seed), curve_of(runs.slurry, seed))};
  if (seed.has(kDrag)) charts.push_back(gap_chart(gap_of(seed), kSpeed));
  std::vector<NamedGroove> all;
  for (std::size_t k = 0; k < std::size(kCases); ++k) {
    if (!seed.has(groove_name(k))) continue;
    all.push_back({kCases[k].name, kCases[k].pressure, groove_of(seed, k)});
    charts.push_back(section_chart(all.back(), k + 1));
  }
  if (all.empty()) return charts;
  charts.push_back(stress_chart(all));
  charts.push_back(distance_chart(all));
  charts.push_back(grain_chart(all));
  return charts;
}

}  // namespace

LabPlan plan_wire_sawing(const LabSetting& setting) {
  LabPlan plan;
  const SawingRuns runs(extent_of(setting.size), plan);
  add_formulas(plan);
  add_viscosities(runs, plan);
  add_drag(plan);
  add_sawing(plan);
  plan.charts = [runs](const SeedResults& seed) { return charts_of(runs, seed); };
  return plan;
}

}  // namespace diefill::process::laboratory
