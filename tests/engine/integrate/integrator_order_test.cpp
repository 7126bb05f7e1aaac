// The integrator is of second order while forces are smooth (Bierwisch 2009, Eqs. 2.2, 2.18, 2.25).
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

SimulationSettings settings_of(double time_step, double damping_over_radius, double friction) {
  auto settings =
      weightless(Model::d, {.damping_over_radius = damping_over_radius, .friction = friction}, time_step);
  settings.lever_arm = LeverArm::contact;
  return settings;
}

/// Two D grains in the middle of an oblique collision, found with very short steps.
Snapshot mid_collision(double damping_over_radius, double friction) {
  Simulation simulation(settings_of(1e-9, damping_over_radius, friction), {});
  const double radius = simulation.settings().shape().sphere_radius;
  NewGrain left, right;
  left.position = {-2.99 * radius, 0, 0};
  left.velocity = {0.1, 0.02, 0};
  right.position = {2.99 * radius, 0.3 * radius, 0.1 * radius};
  right.velocity = -left.velocity;
  right.angular_velocity = {30, 200, -100};
  simulation.add_grains({left, right});
  while (simulation.deepest_overlap() < 0.02 * radius) simulation.step();
  Snapshot start = simulation.snapshot();
  start.step = 0;
  start.time = 0;
  return start;
}

/// Observed order of position, velocity and orientation after 10 us more, still within the contact.
double observed_order(double damping_over_radius, double friction) {
  const Snapshot start = mid_collision(damping_over_radius, friction);
  const double duration = 1e-5;
  const auto at = [&](int steps) {
    Simulation simulation(settings_of(duration / steps, damping_over_radius, friction), {});
    simulation.restore(start);
    run_steps(simulation, steps);
    EXPECT_EQ(simulation.touching_pairs(), 1U);
    const std::size_t k = place_of(simulation, 1);
    const auto& grains = simulation.grains();
    Eigen::VectorXd state(10);
    state << grains.position[k] / simulation.settings().shape().sphere_radius, grains.velocity[k],
        grains.orientation_of(k);
    return state;
  };
  const Eigen::VectorXd coarse = at(50), middle = at(100), fine = at(200);
  return std::log2((coarse - middle).norm() / (middle - fine).norm());
}

TEST(IntegratorOrder, ElasticContactIsSecondOrder) {
  const double order = observed_order(0, 0);
  EXPECT_NEAR(order, 2, 0.1);
}

TEST(IntegratorOrder, DampedContactIsSecondOrder) {
  // The full-step prediction of velocities (OP-3) does not cost the order.
  const double order = observed_order(1e5, 0);
  EXPECT_NEAR(order, 2, 0.1);
}

TEST(IntegratorOrder, SpringIsAtLeastFirstOrder) {
  // The spring is stretched with the predicted velocity over a whole step (OP-4): first order.
  const double order = observed_order(0, 10);
  EXPECT_GT(order, 0.9);
}

}  // namespace
}  // namespace diefill::engine
