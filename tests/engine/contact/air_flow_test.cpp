// Air that a moving tool draws through the powder.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/air_flow.h"
#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kResistance = 4e-4;  // N s/m
constexpr double kTimeStep = 1e-7;    // s
constexpr double kToolSpeed = -0.2;   // m/s

/// A weightless grain each inside and outside of the way of the air that a far plate draws.
Simulation drawn_grains(const std::optional<SleepSettings>& sleep = {}) {
  auto settings = weightless(Model::d, {}, kTimeStep);
  settings.sleep = sleep;
  settings.air_flow = AirFlow{0, {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1e-2, 1, 1)}, {kResistance}};
  WallBodySpec plate;
  plate.centres = {{0, 0, -10}};
  plate.sphere_radius = 1e-3;
  Simulation simulation(settings, {plate});
  simulation.set_motion(0, [](double time) {
    BodyMotion motion;
    motion.translation.z() = kToolSpeed * time;
    motion.velocity.z() = kToolSpeed;
    return motion;
  });
  simulation.add_grains({NewGrain{.position = {0, 0, 0}}, NewGrain{.position = {2e-2, 0, 0}}});
  return simulation;
}

TEST(AirFlow, TakesGrainsInItsWayToTheSpeedOfTheTool) {
  Simulation simulation = drawn_grains();
  const double rate = kResistance / simulation.settings().shape().mass;  // 1/s
  run_steps(simulation, static_cast<int>(1 / (rate * kTimeStep)));
  for (std::size_t k = 0; k < 2; ++k) {
    const bool inside = simulation.grains().position[k].x() < 1e-2;
    const double expected = inside ? kToolSpeed * (1 - std::exp(-rate * simulation.time())) : 0;
    // The first prediction knows no force yet: half a step late.
    const double late = 0.5 * kTimeStep * rate * std::abs(kToolSpeed);
    EXPECT_NEAR(simulation.grains().velocity[k].z(), expected, late) << inside;
    EXPECT_EQ(simulation.grains().velocity[k].x(), 0);
  }
}

TEST(AirFlow, IsBookedAsWorkOfTheAir) {
  Simulation simulation = drawn_grains();
  run_steps(simulation, 2000);
  EXPECT_GT(simulation.ledger().drag_work, 0);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-2);
}

/// Neighbours that do not touch, but are near enough for blocks to keep sums of each other's grains.
TEST(AirFlow, TakesGrainsAlikeWhateverBlockTheyAreIn) {
  constexpr std::size_t kAlong = 12;
  auto settings = weightless(Model::b, {}, kTimeStep);
  settings.air_flow = AirFlow{0, {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)}, {kResistance}};
  WallBodySpec plate;
  plate.centres = {{0, 0, -10}};
  plate.sphere_radius = 1e-3;
  Simulation simulation(settings, {plate});
  simulation.set_motion(0, [](double) {
    BodyMotion motion;
    motion.velocity.z() = kToolSpeed;
    return motion;
  });
  const double apart = 2.02 * settings.shape().sphere_radius;
  std::vector<NewGrain> lattice;
  for (std::size_t k = 0; k < kAlong * kAlong * kAlong; ++k) {
    NewGrain grain;
    const std::size_t place[] = {k % kAlong, k / kAlong % kAlong, k / (kAlong * kAlong)};
    for (int axis = 0; axis < 3; ++axis) grain.position[axis] = apart * static_cast<double>(place[axis]);
    lattice.push_back(grain);
  }
  simulation.add_grains(lattice);
  const auto& blocks = simulation.neighbours().blocks();
  ASSERT_GT(blocks.size(), 1U);
  ASSERT_FALSE(blocks[0].foreign.empty());
  run_steps(simulation, 200);
  ASSERT_EQ(simulation.touching_pairs(), 0U);
  const double speed = simulation.grains().velocity[0].z();
  EXPECT_LT(speed, 0);
  for (const auto& velocity : simulation.grains().velocity) EXPECT_EQ(velocity.z(), speed);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-2);
}

TEST(AirFlow, IsRefusedWhereGrainsSleep) {
  EXPECT_THROW(drawn_grains(SleepSettings{}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
