// Rolling resistance at large coefficients and steps: the spin that the constant torque leaves in a sphere at
// rest, and the step that the elastic-plastic spring EPSD2 needs.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulation/simulation.h"
#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;
namespace laws = engine::laws;

constexpr double kModulus = 5.5e6, kShear = 1.13e6;  // Pa, E* and G* of 10 MPa spheres with nu = 0.3

/// A sphere at rest on a plane under gravity.
engine::SimulationSettings resting_sphere(const laws::AnyRolling::Parameters& rolling) {
  engine::SimulationSettings settings;
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  settings.types = {{engine::model_b(sphere.sphere_radius, sphere.mass)}};
  laws::LawParameters law{.normal = laws::HertzMindlinNormal::Parameters{.modulus = kModulus}};
  law.damping = laws::RestitutionDamping::Parameters{.restitution = 0.3, .modulus = kModulus};
  law.friction =
      laws::MindlinFriction::Parameters{.shear_modulus = kShear, .friction = 0.5, .restitution = 0.3};
  law.rolling = rolling;
  settings.contact = engine::one_powder(law, law);
  return settings;
}

/// m, overlap of a sphere that rests on the plane.
double resting_overlap(const engine::GrainShape& sphere) {
  const double spring = 4.0 / 3.0 * kModulus * std::sqrt(sphere.sphere_radius);
  return std::pow(sphere.mass * engine::kStandardGravity / spring, 2.0 / 3.0);
}

/// rad/s, largest spin in the last fifth of `duration` (s) of a sphere that rests on the plane and is set
/// rolling at `spin` (rad/s).
double spin_that_remains(engine::SimulationSettings settings, double time_step, double duration,
                         double spin) {
  settings.time_step = time_step;
  engine::Simulation simulation(settings, {floor_plate()});
  engine::NewGrain grain;
  grain.position.z() = settings.shape().sphere_radius - resting_overlap(settings.shape());
  grain.velocity.x() = spin * settings.shape().sphere_radius;
  grain.angular_velocity.y() = spin;
  simulation.add_grains({grain});
  const auto steps = std::lround(duration / time_step);
  double largest = 0;
  for (long k = 0; k < steps; ++k) {
    simulation.step();
    if (k > 4 * steps / 5) largest = std::max(largest, simulation.angular_velocity(0).norm());
  }
  return std::isfinite(largest) ? largest : std::numeric_limits<double>::max();
}

double moment_of_inertia(const engine::GrainShape& sphere) {
  return 0.4 * sphere.mass * sphere.sphere_radius * sphere.sphere_radius;
}

void chatter(const ExperimentOptions& options, results::ExperimentResult& result) {
  constexpr double kStep = 5e-6, kMin = 1e-8;  // s; rad/s, what the chart goes down to
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  results::ExperimentChart chart;
  chart.name = "rolling_chatter";
  chart.title = "Residual spin of a resting sphere with a constant rolling torque";
  chart.subtitle = "Steps of 5 us, 0.5 s after a start at 5 rad/s";
  chart.note =
      "As published: half the change by a torque that reverses in every step, mu_r R m g dt / 2 I. "
      "Lower edge: that or less.";
  chart.x = {.label = "Rolling friction coefficient", .logarithmic = true};
  chart.y = {.label = "Largest spin [rad/s]", .logarithmic = true, .lower = kMin, .upper = 1};
  ExperimentSeries left{.name = "constant torque", .x = {}, .y = {}};
  ExperimentSeries printed{.name = "as printed (theory)", .role = Role::predicted, .x = {}, .y = {}};
  for (const double coefficient : logarithmic_range(0.01, 1, options.quick ? 7 : 15)) {
    for (auto* curve : {&left, &printed}) curve->x.push_back(coefficient);
    const laws::LoadRolling::Parameters rolling{.rolling_friction = coefficient};
    left.y.push_back(std::max(kMin, spin_that_remains(resting_sphere(rolling), kStep, 0.5, 5)));
    printed.y.push_back(0.5 * coefficient * sphere.sphere_radius * sphere.mass * engine::kStandardGravity *
                        kStep / moment_of_inertia(sphere));
  }
  result.limits.push_back({"spin left by a constant torque, mu_r = 1, 5 us", left.y.back(), std::nan(""),
                           "rad/s", "as printed: mu_r R m g dt / 2 I"});
  chart.series = {left, printed};
  result.charts.push_back(chart);
}

/// s, 2 / eigenfrequency of a sphere on its normal, tangential (8 G* sqrt(R h)) and rolling spring (8 G*
/// sqrt(R h) R^2 of the law's own modulus `rolling`), the stiffest of the three modes.
double epsd2_step(const engine::GrainShape& sphere, double rolling) {
  const double radius = sphere.sphere_radius;
  const double contact = std::sqrt(radius * resting_overlap(sphere));
  const double normal = 2 * kModulus * contact / sphere.mass;
  const double slide = 8 * kShear * contact;
  const double translation = slide / sphere.mass;
  const double rotation = (slide + 8 * rolling * contact) * radius * radius / moment_of_inertia(sphere);
  const double coupling = slide * radius / std::sqrt(sphere.mass * moment_of_inertia(sphere));
  const double mean = 0.5 * (translation + rotation);
  const double fastest = mean + std::sqrt(0.25 * std::pow(translation - rotation, 2) + coupling * coupling);
  return 2 / std::sqrt(std::max(normal, fastest));
}

void epsd2(const ExperimentOptions& options, results::ExperimentResult& result) {
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  results::ExperimentChart chart;
  chart.name = "rolling_epsd2";
  chart.title = "Time step at which the rolling spring EPSD2 becomes unstable";
  chart.subtitle = "Sphere on a plane under its own weight, rolling coefficient 1";
  chart.note =
      "Theory: 2 over the fastest mode of normal, tangential and rolling spring. G* over E* of real spheres: "
      "0.2.";
  chart.x = {.label = "Shear modulus of the rolling spring over E*", .logarithmic = true};
  chart.y = {.label = "Time step [us]", .logarithmic = true};
  ExperimentSeries measured{.name = "measured", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "theory", .role = Role::predicted, .x = {}, .y = {}};
  constexpr double kTouch = 1e-6;  // rad/s: a growing oscillation is seen before the torque's limit ends it
  const auto limit = [&](double shear) {
    const double predicted = epsd2_step(sphere, shear);
    const laws::Epsd2Rolling::Parameters rolling{.rolling_friction = 1, .shear_modulus = shear};
    const auto settings = resting_sphere(rolling);
    return largest_that_holds(0.05 * predicted, 5 * predicted, 0.03, [&](double time_step) {
      return spin_that_remains(settings, time_step, 4000 * time_step, kTouch) < 10 * kTouch;
    });
  };
  for (const double ratio : logarithmic_range(0.2, 200, options.quick ? 7 : 13)) {
    measured.x.push_back(ratio);
    theory.x.push_back(ratio);
    measured.y.push_back(1e6 * limit(ratio * kModulus));
    theory.y.push_back(1e6 * epsd2_step(sphere, ratio * kModulus));
  }
  result.limits.push_back({"EPSD2 with its own modulus: step at which it becomes unstable", limit(kShear),
                           epsd2_step(sphere, kShear), "s",
                           "2 over the fastest mode of normal, tangential and rolling spring"});
  chart.series = {measured, theory};
  result.charts.push_back(chart);
}

}  // namespace

void find_rolling_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  chatter(options, result);
  epsd2(options, result);
}

}  // namespace diefill::process::laboratory
