// The smallest gap of capillary bridges, below which their force is held: what it changes, and the step that
// the bridge needs.
#include <cmath>
#include <numbers>

#include "process/laboratory/stability/pair_collision.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;
namespace laws = engine::laws;

constexpr double kTension = 0.05;  // N/m (Hu 2024, section 4.3.1)

laws::CapillaryBridge::Parameters bridge_of(double smallest_gap) {
  return {.surface_tension = kTension, .smallest_gap = smallest_gap};
}

laws::PairProperties pair() {
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  return {sphere.sphere_radius, sphere.sphere_radius, sphere.mass, sphere.mass};
}

/// J, energy that the bridge takes from two grains that meet and part: they gain nothing on approach, when
/// there is no bridge yet, and do all the work against it on separation.
double work_of_bridge(double smallest_gap) {
  const laws::CapillaryBridge bridge(bridge_of(smallest_gap), pair());
  const double formed = 1;
  return -bridge.energy(0, &formed);
}

/// m, over which the force of the bridge falls off.
double length_of_bridge() {
  return std::sqrt(laws::CapillaryBridge(bridge_of(1e-9), pair()).spread);
}

engine::SimulationSettings with_bridge(double smallest_gap, double time_step) {
  engine::SimulationSettings settings;
  settings.types = {{engine::model_b(pair().radius_i, pair().mass_i)}};
  settings.gravity.setZero();
  settings.time_step = time_step;
  laws::LawParameters law;
  law.normal = laws::HertzMindlinNormal::Parameters{.modulus = 5e6};
  law.attraction = bridge_of(smallest_gap);
  laws::LawParameters walls = law;
  walls.attraction = {};
  settings.contact = engine::one_powder(law, walls);
  return settings;
}

/// J that a pair has lost when it has parted, in steps of `time_step` (s).
double lost(double smallest_gap, double time_step) {
  const double mass = 0.5 * pair().mass_i;
  const double speed = 1.5 * std::sqrt(2 * work_of_bridge(1e-9) / mass);
  const double rupture = laws::CapillaryBridge(bridge_of(smallest_gap), pair()).rupture;
  const double way = 4 * (rupture + 1e-5);
  double sum = 0;
  constexpr int kPhases = 4;
  for (int k = 0; k < kPhases; ++k) {
    const auto end =
        meet_head_on(with_bridge(smallest_gap, time_step), speed, (k + 0.5) / kPhases,
                     std::lround(3e-4 / time_step + 10 * way / (speed * time_step)), 1.01 * rupture);
    sum += 0.5 * mass * (speed * speed - end.rebound * end.rebound);
  }
  return sum / kPhases;
}

}  // namespace

void find_capillary_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "capillary_smallest_gap";
  chart.title = "Effect of the smallest gap of a capillary bridge";
  chart.subtitle =
      "0.05 N/m, 5 % liquid, spheres of 0.15 mm radius that part at 1.5 times the speed of escape";
  chart.note = "Steps of 0.1 us. Exact: without a smallest gap.";
  chart.x = {.label = "Smallest gap [um]", .logarithmic = true};
  chart.y = {.label = "Work of separation over the exact value"};
  ExperimentSeries measured{.name = "measured", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "integral of the force", .role = Role::predicted, .x = {}, .y = {}};
  const double exact = work_of_bridge(1e-12);
  for (const double gap : logarithmic_range(1e-9, 3e-5, options.quick ? 10 : 19)) {
    for (auto* curve : {&measured, &theory}) curve->x.push_back(1e6 * gap);
    measured.y.push_back(lost(gap, 1e-7) / exact);
    theory.y.push_back(work_of_bridge(gap) / exact);
  }
  chart.series = {measured, theory};
  result.charts.push_back(chart);

  const double largest = largest_that_holds(
      1e-9, 3e-5, 0.03, [&](double gap) { return std::abs(lost(gap, 1e-7) / exact - 1) < 0.01; });
  result.limits.push_back(
      {"capillary: smallest gap that changes the work by 1 %", largest,
       largest_that_holds(1e-9, 3e-5, 1e-3,
                          [&](double gap) { return std::abs(work_of_bridge(gap) / exact - 1) < 0.01; }),
       "m", "integral of the force"});
  for (const double gap : {1e-9, 1e-6}) {
    const double step = largest_that_holds(1e-7, 1e-4, 0.03, [&](double time_step) {
      return std::abs(lost(gap, time_step) / work_of_bridge(gap) - 1) < 0.05;
    });
    const double mass = 0.5 * pair().mass_i;
    const double passing = length_of_bridge() / (1.5 * std::sqrt(2 * exact / mass));
    result.limits.push_back({gap < 1e-8
                                 ? "capillary, smallest gap 1 nm: step with the work right within 0.05"
                                 : "capillary, smallest gap 1 um: step with the work right within 0.05",
                             step, passing, "s", "length of the bridge over speed"});
  }
}

}  // namespace diefill::process::laboratory
