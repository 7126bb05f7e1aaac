// Model B: torque of tangential forces (Bierwisch 2009, Eq. 2.10) and rolling friction (Eq. 2.11, OP-9).
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

SimulationSettings on_plane(double friction, double rolling_friction) {
  auto settings = weightless(Model::b, {.friction = friction, .rolling_friction = rolling_friction}, 2e-6);
  wall_contact(settings)->friction = friction;
  settings.gravity = {0, 0, -9.81};
  return settings;
}

Simulation thrown(const SimulationSettings& settings, double speed, double turning) {
  Simulation simulation(settings, {plane_wall()});
  NewGrain grain;
  grain.position = {0, 0, settings.shape().sphere_radius - 4.4e-8};
  grain.velocity = {speed, 0, 0};
  grain.angular_velocity = {0, turning, 0};
  simulation.add_grains({grain});
  return simulation;
}

TEST(Rolling, SlidingSphereRollsInTheEndAtFiveSeventhsOfItsSpeed) {
  const double speed = 0.1, friction = 0.3;
  const auto settings = on_plane(friction, 0);
  auto simulation = thrown(settings, speed, 0);
  const double slip_time = 2 * speed / (7 * friction * 9.81);
  while (simulation.time() < 0.5 * slip_time) simulation.step();
  EXPECT_NEAR(velocity_of(simulation, 0).x(), speed - friction * 9.81 * simulation.time(), 2e-3 * speed);
  while (simulation.time() < 1.5 * slip_time) simulation.step();
  double mean_speed = 0, mean_rim = 0;
  const int steps = 5000;
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    mean_speed += velocity_of(simulation, 0).x() / steps;
    mean_rim += simulation.angular_velocity(0).y() * settings.shape().sphere_radius / steps;
  }
  EXPECT_NEAR(mean_speed, 5.0 / 7.0 * speed, 1e-3 * speed);
  EXPECT_NEAR(mean_rim, mean_speed, 1e-3 * speed);
}

TEST(Rolling, BackspinnedSphereComesBack) {
  // Angular momentum about the contact line stays: v_end = (v - 2/5 R |omega|) 5/7 < 0.
  const double speed = 0.05, friction = 0.3;
  const auto settings = on_plane(friction, 0);
  const double turning = -4 * speed / settings.shape().sphere_radius;
  auto simulation = thrown(settings, speed, turning);
  while (simulation.time() < 0.04) simulation.step();
  double mean = 0;
  for (int k = 0; k < 5000; ++k) {
    simulation.step();
    mean += velocity_of(simulation, 0).x() / 5000;
  }
  EXPECT_NEAR(mean, 5.0 / 7.0 * (speed + 0.4 * settings.shape().sphere_radius * turning), 2e-3 * speed);
  EXPECT_LT(mean, 0);
}

TEST(Rolling, RollingFrictionBrakesEvenlyAndStops) {
  // Rolling without slip under a torque mu_r N: a = -5/7 mu_r g / R.
  const double speed = 0.05, rolling = 3.75e-5;
  const auto settings = on_plane(0.5, rolling);
  const double radius = settings.shape().sphere_radius;
  auto simulation = thrown(settings, speed, speed / radius);
  const double braking = 5.0 / 7.0 * rolling * 9.81 / radius;
  while (simulation.time() < 0.5 * speed / braking) simulation.step();
  EXPECT_NEAR(velocity_of(simulation, 0).x(), 0.5 * speed, 0.02 * speed);
  double least_spin = speed / radius;
  while (simulation.time() < 2 * speed / braking) {
    simulation.step();
    least_spin = std::min(least_spin, simulation.angular_velocity(0).y());
  }
  EXPECT_NEAR(position_of(simulation, 0).x(), 0.5 * speed * speed / braking,
              0.01 * 0.5 * speed * speed / braking);
  EXPECT_GE(least_spin, -1e-6 * speed / radius);
  EXPECT_LT(std::abs(simulation.angular_velocity(0).y()), 1e-6 * speed / radius);
}

TEST(Rolling, HugeRollingFrictionHoldsASphereWithoutChatter) {
  // B1: mu_r = 2.5 R. The torque would reverse the spin in one step if it were not limited.
  const auto settings = on_plane(1, 3.75e-4);
  auto simulation = thrown(settings, 0, 20);
  double sign_changes = 0, before = 20;
  for (int k = 0; k < 5000; ++k) {
    simulation.step();
    const double now = simulation.angular_velocity(0).y();
    if (now * before < 0) ++sign_changes;
    before = now;
  }
  EXPECT_EQ(sign_changes, 0);
  EXPECT_LT(std::abs(before), 1e-3);
}

TEST(Rolling, TwoSpheresInGlancingContactTurnTheSameWay) {
  const auto settings = weightless(Model::b, {.friction = 1}, 1e-7);
  Simulation simulation(settings, {});
  NewGrain left, right;
  left.position = {-settings.shape().sphere_radius, 0, 0};
  left.velocity = {0.1, 0.1, 0};
  right.position = -left.position;
  right.velocity = -left.velocity;
  simulation.add_grains({left, right});
  run_steps(simulation, 1500);
  const Eigen::Vector3d first = simulation.angular_velocity(place_of(simulation, 0));
  const Eigen::Vector3d second = simulation.angular_velocity(place_of(simulation, 1));
  // i at -x moves up along j's surface: friction on i points down, at arm +x; the torque is along -z.
  EXPECT_LT(first.z(), 0);
  EXPECT_NEAR(first.z(), second.z(), 1e-12 * std::abs(first.z()));
  EXPECT_EQ(first.x(), 0);
  EXPECT_EQ(simulation.touching_pairs(), 0U);
}

TEST(Rolling, ModelANeverTurns) {
  const auto settings = weightless(Model::a, {.friction = 1}, 1e-7);
  Simulation simulation(settings, {});
  NewGrain left, right;
  left.position = {-settings.shape().sphere_radius, 0, 0};
  left.velocity = {0.1, 0.1, 0};
  right.position = -left.position;
  simulation.add_grains({left, right});
  run_steps(simulation, 1000);
  for (const auto& spin : simulation.grains().spin) EXPECT_EQ(spin.norm(), 0);
  EXPECT_GT(velocity_of(simulation, 1).y(), 0.01);
}

}  // namespace
}  // namespace diefill::engine
