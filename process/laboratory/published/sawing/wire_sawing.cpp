// Wire sawing (Bierwisch 2009, appendix A). No scene has a fluid of particles: quantities are measured in
// runs of their own, one of each kind and seed, in reduced units.
#include "process/laboratory/published/sawing/wire_sawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/sawing/groove.h"
#include "process/laboratory/published/sawing/groove_charts.h"
#include "process/laboratory/published/sawing/viscosity.h"

namespace diefill::process::laboratory {
namespace {

using namespace sawing;

/// Runs made once for each seed, when they are first asked for.
template <class Figures>
class Runs {
 public:
  explicit Runs(std::function<Figures(std::uint64_t seed)> make) : make_(std::move(make)) {}
  const Figures& of(std::uint64_t seed) {
    const auto found = made_.find(seed);
    return found != made_.end() ? found->second : made_.emplace(seed, make_(seed)).first->second;
  }

 private:
  std::function<Figures(std::uint64_t)> make_;
  std::map<std::uint64_t, Figures> made_;
};

/// How much of the published experiment each size does.
struct Extent {
  std::vector<double> rates;                      ///< of the fluid
  double fluid_edge, slurry_edge, groove_length;  ///< r_c
  double longer;                                  ///< of all sampled times
};

Extent extent_of(LabSize size) {
  switch (size) {
    case LabSize::coarse:
      return {{0.1, 0.2}, 8, 12, 6, 1};
    case LabSize::medium:
      return {{0.05, 0.1, 0.2}, 10, 20, 12, 2};
    case LabSize::published:
      break;
  }
  return {{0.02, 0.05, 0.1, 0.2}, 10, 30, 20, 10};
}

int steps(double count, const Extent& extent) {
  return static_cast<int>(count * extent.longer);
}

constexpr double kSlurryRates[] = {0.1, 0.2};

/// Viscosity at several shear rates.
using Viscosities = std::vector<ShearedFigures>;

Viscosities fluid_viscosities(const Extent& extent, std::uint64_t seed) {
  Viscosities all;
  for (const double rate : extent.rates) {  // the smaller the stress, the more of its scatter is averaged
    constexpr double kAtOne = 500;          // steps, over the square of the rate
    all.push_back(measure({.edge = extent.fluid_edge,
                           .rate = rate,
                           .settling = 1000,
                           .sampled = steps(std::min(200000.0, kAtOne / (rate * rate)), extent)},
                          seed));
  }
  return all;
}

Viscosities slurry_viscosities(const Extent& extent, std::uint64_t seed) {
  Viscosities all;
  for (const double rate : kSlurryRates)
    all.push_back(measure({.edge = extent.slurry_edge,
                           .rate = rate,
                           .solids = 0.25,
                           .settling = 2000,
                           .sampled = steps(6000, extent)},
                          seed));
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

GrooveFigures drag(const Extent& extent, std::uint64_t seed) {
  return saw({.length = extent.groove_length,
              .speed = kSpeed,
              .settling = steps(6000, extent),
              .sampled = steps(8000, extent)},
             seed);
}

GrooveFigures saw_slurry(const SawingCase& one, const Extent& extent, std::uint64_t seed) {
  return saw({.length = extent.groove_length,
              .speed = kSpeed * one.speed / kSpeedOfProcess,
              .pressure = one.pressure / ReducedUnits::pressure_of_process,
              .solids = 0.25,
              .settling = steps(8000, extent),
              .sampled = steps(4000, extent)},
             seed);
}

/// All runs of the experiment.
struct SawingRuns {
  explicit SawingRuns(const Extent& extent)
      : fluid([=](std::uint64_t seed) { return fluid_viscosities(extent, seed); }),
        slurry([=](std::uint64_t seed) { return slurry_viscosities(extent, seed); }),
        still([=](std::uint64_t seed) {
          return measure({.edge = extent.fluid_edge, .rate = 0, .sampled = steps(2000, extent)}, seed);
        }),
        dragged([=](std::uint64_t seed) { return drag(extent, seed); }) {
    for (const SawingCase& one : kCases)
      sawn.emplace_back([=](std::uint64_t seed) { return saw_slurry(one, extent, seed); });
  }
  Runs<Viscosities> fluid, slurry;
  Runs<ShearedFigures> still;
  Runs<GrooveFigures> dragged;
  std::vector<Runs<GrooveFigures>> sawn;
};

using SharedRuns = std::shared_ptr<SawingRuns>;
using ValueOf = double (*)(SawingRuns& runs, std::uint64_t seed);

void add(LabPlan& plan, const SharedRuns& runs, const std::string& id, const std::string& quantity,
         const std::string& unit, const ValueOf& value) {
  plan.quantities.push_back(
      {.id = id, .quantity = quantity, .unit = unit, .runs = {}, .value = [=](const SeedResults& seed) {
         return value(*runs, seed.seed());
       }});
}

/// Reynolds number (Eq. A.6): speed (m/s), gap (m), density (kg/m^3), viscosity (Pa s).
double reynolds(double speed, double gap, double density, double viscosity) {
  return speed * gap * density / viscosity;
}

void add_formulas(LabPlan& plan, const SharedRuns& runs) {
  add(plan, runs, "Z06", "", "", [](SawingRuns&, std::uint64_t) { return reynolds(17, 20e-6, 1700, 0.2); });
  add(plan, runs, "Z07", "", "",
      [](SawingRuns&, std::uint64_t) { return reynolds(122, 4.4e-9, 1700, 0.34e-3); });
}

void add_viscosities(LabPlan& plan, const SharedRuns& runs) {
  add(plan, runs, "Z01", "", "", [](SawingRuns& all, std::uint64_t seed) {
    return ReducedUnits::viscosity * mean_viscosity(all.slurry.of(seed));
  });
  add(plan, runs, "Z02", "", "", [](SawingRuns& all, std::uint64_t seed) {
    return mean_viscosity(all.slurry.of(seed)) / mean_viscosity(all.fluid.of(seed));
  });
  add(plan, runs, "Z03", "", "", [](SawingRuns& all, std::uint64_t seed) {
    return ReducedUnits::viscosity * mean_viscosity(all.fluid.of(seed));
  });
  add(plan, runs, "Z04", "", "",
      [](SawingRuns& all, std::uint64_t seed) { return largest_difference(all.fluid.of(seed)); });
  add(plan, runs, "SAW-temperature", "temperature of the fluid at rest over the one asked for", "1",
      [](SawingRuns& all, std::uint64_t seed) { return all.still.of(seed).temperature; });
  add(plan, runs, "SAW-pressure", "pressure of the fluid at rest at density 4.15, reduced", "1",
      [](SawingRuns& all, std::uint64_t seed) { return all.still.of(seed).pressure; });
  add(plan, runs, "SAW-solids", "share of solids in the slurry of the viscosity", "1",
      [](SawingRuns& all, std::uint64_t seed) { return all.slurry.of(seed).front().solids; });
}

void add_drag(LabPlan& plan, const SharedRuns& runs) {
  add(plan, runs, "Z05", "", "",
      [](SawingRuns& all, std::uint64_t seed) { return line_through(all.dragged.of(seed).gap).r_squared; });
  add(plan, runs, "SAW-slip-wire", "slip of the fluid at the wire over its speed", "1",
      [](SawingRuns& all, std::uint64_t seed) {
        return std::abs(1 - speed_at(all.dragged.of(seed).gap, GrooveCase().wire_radius) / kSpeed);
      });
  add(plan, runs, "SAW-slip-ingot", "slip of the fluid at the ingot over the speed of the wire", "1",
      [](SawingRuns& all, std::uint64_t seed) {
        return std::abs(speed_at(all.dragged.of(seed).gap, GrooveCase().groove_radius) / kSpeed);
      });
}

constexpr std::size_t kNonContact = 0, kSemiContact = 1;  // of kCases

void add_sawing(LabPlan& plan, const SharedRuns& runs) {
  add(plan, runs, "Z08", "", "", [](SawingRuns& all, std::uint64_t seed) {
    return share_at_centre(all.sawn[kSemiContact].of(seed)) / share_at_centre(all.sawn[kNonContact].of(seed));
  });
  add(plan, runs, "Z09", "", "", [](SawingRuns& all, std::uint64_t seed) {
    return stress_at_sides(all.sawn[kSemiContact].of(seed)) / stress_at_sides(all.sawn[kNonContact].of(seed));
  });
  for (std::size_t k = 0; k < std::size(kCases); ++k)
    plan.quantities.push_back({.id = "SAW-distance-" + std::to_string(k + 1),
                               .quantity = std::string("wire to ingot, ") + kCases[k].name,
                               .unit = "um",
                               .runs = {},
                               .value = [=](const SeedResults& seed) {
                                 return ReducedUnits::micrometres *
                                        runs->sawn[k].of(seed.seed()).mean_distance;
                               }});
  for (const std::size_t k : {kNonContact, kSemiContact})
    for (std::size_t size = 0; size < SlurryMixture().sizes.size(); ++size)
      plan.quantities.push_back(
          {.id = "SAW-grains-" + std::to_string(k + 1) + '-' + std::to_string(size + 1),
           .quantity = "grains of " + plain(ReducedUnits::micrometres * SlurryMixture().sizes[size]) +
                       " um under more than 25 N/mm2, " + kCases[k].name,
           .unit = "1",
           .runs = {},
           .value = [=](const SeedResults& seed) {
             return grains_of(runs->sawn[k].of(seed.seed()), SlurryMixture().sizes[size]).high;
           }});
}

std::vector<results::ExperimentChart> charts_of(const std::vector<double>& rates, SawingRuns& runs,
                                                std::uint64_t seed) {
  std::vector<results::ExperimentChart> charts = {
      viscosity_chart(rates, runs.fluid.of(seed), {std::begin(kSlurryRates), std::end(kSlurryRates)},
                      runs.slurry.of(seed)),
      gap_chart(runs.dragged.of(seed).gap, kSpeed)};
  std::vector<NamedGroove> all;
  for (std::size_t k = 0; k < std::size(kCases); ++k)
    all.push_back({kCases[k].name, kCases[k].pressure, &runs.sawn[k].of(seed)});
  charts.push_back(stress_chart(all));
  charts.push_back(distance_chart(all));
  for (std::size_t k = 0; k < all.size(); ++k) charts.push_back(section_chart(all[k], k + 1));
  return charts;
}

}  // namespace

LabPlan plan_wire_sawing(const LabSetting& setting) {
  const Extent extent = extent_of(setting.size);
  const auto runs = std::make_shared<SawingRuns>(extent);
  LabPlan plan;
  plan.simulates = true;
  add_formulas(plan, runs);
  add_viscosities(plan, runs);
  add_drag(plan, runs);
  add_sawing(plan, runs);
  plan.charts = [runs, rates = extent.rates](const std::vector<SeedResults>& seeds) {
    return charts_of(rates, *runs, seeds.front().seed());
  };
  return plan;
}

}  // namespace diefill::process::laboratory
