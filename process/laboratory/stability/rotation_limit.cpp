// How fast a grain may spin: energy and angular momentum of a body that tumbles freely, and the norm of its
// quaternion, against spin times step.
#include <cmath>
#include <numbers>

#include "engine/observe/energy_balance.h"
#include "engine/powder/rigid_motion.h"
#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

/// Three spheres at the corners of a flat triangle with sides of different length: three different moments.
engine::GrainShape uneven_grain() {
  constexpr double kRadius = 7.84e-5;
  return engine::rigid_grain(kRadius, {{0, 0, 0}, {2 * kRadius, 0, 0}, {0.5 * kRadius, 3 * kRadius, 0}}, 3e-8,
                             3 * 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius);
}

struct Tumble {
  double energy_error = 0, direction_error = 0, norm_error = 0;
};

/// Spins freely for `turns` turns at `angle` (rad) a step, mostly about the middle axis, which is unstable.
Tumble tumble(const engine::GrainShape& shape, double angle, double turns) {
  constexpr double kSpin = 1000;  // rad/s
  engine::SimulationSettings settings;
  settings.types = {{shape}};
  settings.gravity.setZero();
  settings.time_step = angle / kSpin;
  engine::Simulation simulation(settings, {});
  engine::NewGrain grain;
  grain.angular_velocity = kSpin * Eigen::Vector3d(0.3, 0.9, 0.3).normalized();
  simulation.add_grains({grain});
  const auto momentum = [&]() -> Eigen::Vector3d {
    return engine::rotation_matrix(simulation.grains().orientation_of(0)) *
           shape.inertia.cwiseProduct(simulation.grains().spin[0]);
  };
  const double energy = engine::energy_of(simulation).rotation;
  const Eigen::Vector3d before = momentum();
  const auto steps = std::lround(2 * std::numbers::pi * turns / angle);
  for (long k = 0; k < steps; ++k) simulation.step();
  return {std::abs(engine::energy_of(simulation).rotation / energy - 1),
          (momentum() - before).norm() / before.norm(),
          std::abs(simulation.grains().orientation_of(0).norm() - 1)};
}

/// Never zero, for logarithmic axes, and never beyond them where the scheme has failed.
double drawn(double error) {
  return std::isfinite(error) ? std::min(10.0, std::max(1e-16, error)) : 10.0;
}

}  // namespace

void find_rotation_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const double turns = options.quick ? 100 : 1000;
  const auto shape = uneven_grain();
  results::ExperimentChart chart;
  chart.name = "rotation_drift";
  chart.title = "A freely tumbling grain after " + std::to_string(static_cast<int>(turns)) + " turns";
  chart.subtitle = "Three spheres with three different moments of inertia";
  chart.note = "Theory: second-order scheme.";
  chart.x = {.label = "Angle turned in a step [rad]", .logarithmic = true};
  chart.y = {.label = "Relative error", .logarithmic = true, .lower = 1e-16, .upper = 10};
  ExperimentSeries energy{.name = "energy", .x = {}, .y = {}};
  ExperimentSeries direction{.name = "angular momentum", .x = {}, .y = {}};
  ExperimentSeries norm{.name = "norm of the quaternion", .x = {}, .y = {}};
  ExperimentSeries theory{.name = "second order", .role = Role::predicted, .x = {}, .y = {}};
  for (const double angle : logarithmic_range(1e-3, 1, options.quick ? 10 : 19)) {
    const auto error = tumble(shape, angle, turns);
    for (auto* curve : {&energy, &direction, &norm, &theory}) curve->x.push_back(angle);
    energy.y.push_back(drawn(error.energy_error));
    direction.y.push_back(drawn(error.direction_error));
    norm.y.push_back(drawn(error.norm_error));
    theory.y.push_back(drawn(direction.y.front() * std::pow(angle / energy.x.front(), 2)));
  }
  chart.series = {energy, direction, norm, theory};
  result.charts = {chart};
  const auto angle_for = [&](double allowed, auto figure) {
    return largest_that_holds(1e-3, 1, 0.03,
                              [&](double angle) { return figure(tumble(shape, angle, turns)) < allowed; });
  };
  const std::string after = " after " + std::to_string(static_cast<int>(turns)) + " turns";
  result.limits.push_back({"angle in a step at 1 % of the energy" + after,
                           angle_for(0.01, [](const Tumble& t) { return t.energy_error; }), std::nan(""),
                           "rad", ""});
  result.limits.push_back({"angle in a step at 1 % of the angular momentum" + after,
                           angle_for(0.01, [](const Tumble& t) { return t.direction_error; }), std::nan(""),
                           "rad", ""});
}

}  // namespace diefill::process::laboratory
