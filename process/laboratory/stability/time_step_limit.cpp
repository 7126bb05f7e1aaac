// How long a time step may be: spurious energy gain against the duration of a collision, the Rayleigh time
// and the fastest oscillation of the contact network.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/limits/time_step.h"
#include "engine/powder/sphere_volume.h"
#include "process/laboratory/stability/elastic_gas.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/undamped_bed.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kAllowedGrowth = 0.01;  // of the kinetic energy at the start
constexpr double kSpeed = 0.5;           // m/s, rms per component (Hu 2024, section 4.4, assumed)
constexpr double kDuration = 200;        // collision times
constexpr double kFloor = 1e-5;          // growths below are drawn here: round-off and chance
constexpr double kShortest = 0.03;  // steps tried in a gas, over a collision's duration: far below the limit
constexpr double kLongest = 0.5;

struct GasCase {
  std::string name;
  engine::GrainShape shape;
  engine::ContactParameters contact;
  double spacing;    // m
  double scale = 0;  // l; 0: not part of the scaling
  double friction = 0;
};

/// Spheres of Hu 2024, section 4.4, times l: 0.5 mm, 1000 kg/m^3, E = 100 MPa, nu = 0.3, 0.3 of the volume.
GasCase scaled_spheres(double scale) {
  const double radius = 2.5e-4 * scale;
  const double volume = engine::sphere_volume(radius);
  GasCase spheres;
  spheres.name = "spheres, l = " + std::to_string(static_cast<int>(scale));
  spheres.shape = engine::model_a(radius, 1000 * volume);
  spheres.contact.reduced_modulus = 1e8 / (1 - 0.3 * 0.3);
  spheres.spacing = std::cbrt(volume / 0.3);
  spheres.scale = scale;
  return spheres;
}

GasCase thesis_gas(ThesisGrain kind, const std::string& name, double friction) {
  GasCase gas;
  gas.name = name;
  gas.shape = thesis_grain(kind);
  gas.contact = elastic_contact();
  gas.contact.friction = friction;
  gas.contact.tangential = 1e6 * gas.shape.sphere_radius;
  gas.spacing = 2.05 * gas.shape.bounding_radius();
  return gas;
}

std::vector<GasCase> gas_cases() {
  return {scaled_spheres(1),
          scaled_spheres(2),
          scaled_spheres(4),
          thesis_gas(ThesisGrain::c, "model C", 0),
          thesis_gas(ThesisGrain::d, "model D", 0),
          thesis_gas(ThesisGrain::d, "model D, friction 0.5", 0.5)};
}

results::ExperimentChart empty_gas_chart(const ExperimentOptions& options) {
  results::ExperimentChart chart;
  chart.name = "time_step_gas";
  chart.title = "Spurious energy gain in a gas of grains";
  chart.subtitle = std::string(options.quick ? "200" : "1000") +
                   " collision times without dissipation, 0.5 m/s rms per component; limit 1 %";
  chart.note = "Gains below 1e-5 are drawn at 1e-5, unstable runs at 1.";
  chart.x = {.label = "Time step over duration of a head-on collision at 1 m/s", .logarithmic = true};
  chart.y = {.label = "Energy gained over kinetic energy", .logarithmic = true, .lower = kFloor, .upper = 1};
  return chart;
}

/// Critical steps of spheres of several sizes, beside what they should be.
class ScalingChart {
 public:
  /// `limit`: s, the largest step that holds.
  void add(const GasCase& gas, double limit, std::vector<results::ExperimentLimit>& limits) {
    const double first = measured_.y.empty() ? 1e6 * limit : measured_.y.front();
    for (ExperimentSeries* series : {&measured_, &formula_, &rayleigh_}) series->x.push_back(gas.scale);
    measured_.y.push_back(1e6 * limit);
    formula_.y.push_back(first * gas.scale);
    rayleigh_.y.push_back(0.15e6 * rayleigh_time(gas.shape.sphere_radius, 1000, gas.contact.reduced_modulus));
    limits.push_back({"scaling: critical step of l = " + std::to_string(static_cast<int>(gas.scale)) +
                          " over that of l = 1",
                      1e6 * limit / first, gas.scale, "1", "Hu 2024, section 4.4; same trajectory"});
  }

  results::ExperimentChart chart() const {
    results::ExperimentChart chart;
    chart.name = "time_step_scaling";
    chart.title = "Critical time step of spheres against their size";
    chart.subtitle = "E = 100 MPa, 1000 kg/m3, d = 0.5 mm times l";
    chart.x = {.label = "Scale l", .logarithmic = true};
    chart.y = {.label = "Critical time step [us]", .logarithmic = true};
    chart.series = {measured_, formula_, rayleigh_};
    return chart;
  }

 private:
  ExperimentSeries measured_{.name = "measured, 1 % gained", .x = {}, .y = {}};
  ExperimentSeries formula_{.name = "proportional to l", .role = Role::predicted, .x = {}, .y = {}};
  ExperimentSeries rayleigh_{.name = "0.15 of the Rayleigh time", .role = Role::predicted, .x = {}, .y = {}};
};

void find_in_gas(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart = empty_gas_chart(options);
  ScalingChart scaling;
  for (const auto& each : gas_cases()) {
    const auto gas = elastic_gas(each.shape, each.contact, options.quick ? 6 : 10, each.spacing, kSpeed);
    const double collision = collision_time(each.shape, each.contact, 1.0);
    const double duration = (options.quick ? 1 : 5) * kDuration * collision;
    ExperimentSeries curve{.name = each.name, .x = {}, .y = {}};
    for (const double over : logarithmic_range(kShortest, kLongest, options.quick ? 8 : 16)) {
      curve.x.push_back(over);
      curve.y.push_back(std::clamp(energy_growth(gas, over * collision, duration), kFloor, 1.0));
    }
    chart.series.push_back(curve);
    const double limit = largest_that_holds(
        kShortest * collision, kLongest * collision, 0.03,
        [&](double time_step) { return energy_growth(gas, time_step, duration) < kAllowedGrowth; });
    const double critical =
        engine::critical_time_step(each.shape, engine::laws::bierwisch_law(each.contact), 1.0);
    result.limits.push_back({"gas of " + each.name + ": step at 1 % energy gained", limit, critical, "s",
                             "engine/limits/time_step.h, critical step at 1 m/s"});
    result.limits.push_back({"gas of " + each.name + ": that step over a collision's duration",
                             limit / collision, std::nan(""), "1", ""});
    if (each.scale > 0) scaling.add(each, limit, result.limits);
  }
  result.charts.push_back(chart);
  result.charts.push_back(scaling.chart());
}

struct PileCase {
  std::string name;
  ThesisGrain kind;
  double friction;
};

void find_in_pile(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "time_step_bed";
  chart.title = "Spurious energy gain in a settled bed";
  chart.subtitle =
      "Undamped, shaken by 1 mm/s; theory: stable below 1, the fastest oscillation of the contacts";
  chart.note = "Gains below 1e-5 are drawn at 1e-5, unstable runs at 1.";
  chart.x = {.label = "Time step over 2 / largest eigenfrequency", .lower = 0, .upper = 1.4};
  chart.y = {.label = "Energy gained over elastic and kinetic energy",
             .logarithmic = true,
             .lower = kFloor,
             .upper = 1};
  const long steps = options.quick ? 2000 : 20000;
  const std::vector<PileCase> cases = {{"spheres", ThesisGrain::sphere, 0},
                                       {"model D", ThesisGrain::d, 0},
                                       {"model D, friction 0.5", ThesisGrain::d, 0.5}};
  for (const auto& each : cases) {
    const auto pile = undamped_bed(thesis_grain(each.kind), each.friction, 5, options.quick ? 5 : 12);
    const double stable = 2 / pile.eigenfrequency;
    ExperimentSeries curve{.name = each.name, .x = {}, .y = {}};
    for (const double over : linear_range(0.1, 1.3, options.quick ? 13 : 25)) {
      curve.x.push_back(over);
      curve.y.push_back(std::clamp(bed_energy_growth(pile, over * stable, steps), kFloor, 1.0));
    }
    chart.series.push_back(curve);
    const double limit = largest_that_holds(0.1 * stable, 4 * stable, 0.03, [&](double time_step) {
      return bed_energy_growth(pile, time_step, steps) < kAllowedGrowth;
    });
    result.limits.push_back({"settled bed of " + each.name + ": step at 1 % energy gained", limit, stable,
                             "s", "2 / largest eigenfrequency of the contact network"});
  }
  chart.series.push_back({.name = "theory", .role = Role::predicted, .x = {1, 1}, .y = {kFloor, 1}});
  result.charts.push_back(chart);
}

}  // namespace

void find_time_step_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  find_in_gas(options, result);
  find_in_pile(options, result);
}

}  // namespace diefill::process::laboratory
