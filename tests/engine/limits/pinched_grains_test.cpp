// Grains wedged between tools that move against each other are named, and nothing else is.
#include "engine/limits/pinched_grains.h"

#include <gtest/gtest.h>

#include "engine/limits/chain_stability.h"
#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kLimit = 0.45;  // of the sphere radius

/// A flat tool at height `top` (m) whose powder side looks along `side` (+1 up, -1 down), moving along x.
WallBodySpec jaw(const std::string& name, double top, double side, double speed) {
  WallBodySpec body;
  body.name = name;
  body.planes = {{{0, 0, top}, {0, 0, side}}};
  if (speed != 0)
    body.motion = [speed](double time) {
      BodyMotion motion;
      motion.velocity.x() = speed;
      motion.translation.x() = speed * time;
      return motion;
    };
  return body;
}

/// `grains` single spheres on top of each other between two jaws, `lower` and one that moves at `upper_speed`
/// (m/s), which press each contact in by `over_radius`.
Simulation column_on(WallBodySpec lower, int grains, double over_radius, double upper_speed,
                     double time_step = 1e-9) {
  auto settings = weightless(Model::a, {}, time_step);
  const double radius = settings.shape().sphere_radius, pitch = (2 - over_radius) * radius;
  const double first = (1 - over_radius) * radius;
  Simulation simulation(settings,
                        {std::move(lower), jaw("shoe", 2 * first + (grains - 1) * pitch, -1, upper_speed)});
  std::vector<NewGrain> column(static_cast<std::size_t>(grains));
  for (std::size_t k = 0; k < column.size(); ++k)
    column[k].position.z() = first + static_cast<double>(k) * pitch;
  simulation.add_grains(column);
  simulation.step();
  return simulation;
}

/// The same on a die that moves at `lower_speed` (m/s).
Simulation column_between_jaws(int grains, double over_radius, double lower_speed, double upper_speed,
                               double time_step = 1e-9) {
  return column_on(jaw("die", 0, 1, lower_speed), grains, over_radius, upper_speed, time_step);
}

std::vector<PinchedGrain> named(const Simulation& simulation) {
  return pinched_grains(simulation, kLimit);
}

TEST(PinchedGrains, NamesAGrainBetweenToolsThatMovePastEachOther) {
  const auto simulation = column_between_jaws(1, 0.6, 0, 0.2);
  const auto pinched = named(simulation);
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_EQ(pinched[0].id, 0U);
  const double radius = simulation.settings().shape().sphere_radius;
  EXPECT_NEAR(pinched[0].overlap, 0.6, 1e-6);
  EXPECT_NEAR(pinched[0].position.z(), 0.4 * radius, 1e-6 * radius);
}

TEST(PinchedGrains, NamesOneGrainOfAChainBetweenTwoTools) {
  EXPECT_EQ(named(column_between_jaws(3, 0.6, 0, 0.2)).size(), 1U);
}

TEST(PinchedGrains, LeavesWhatIsPressedLessDeeply) {
  EXPECT_TRUE(named(column_between_jaws(1, 0.4, 0, 0.2)).empty());
}

TEST(PinchedGrains, NamesWhatTheTimeStepDoesNotCarryAlthoughItIsPressedLessDeeply) {
  const auto stability = [](double time_step) {
    return stability_used(column_between_jaws(2, 0.4, 0, 0.2, time_step), {0, 1}).used;
  };
  constexpr double kCarried = 1e-6, kTooLong = 2.5e-6;  // s
  ASSERT_LT(stability(kCarried), 1);
  EXPECT_TRUE(named(column_between_jaws(2, 0.4, 0, 0.2, kCarried)).empty());
  ASSERT_GT(stability(kTooLong), 1);
  EXPECT_EQ(named(column_between_jaws(2, 0.4, 0, 0.2, kTooLong)).size(), 1U);
  // Between tools that stand it is the critical step that speaks.
  EXPECT_TRUE(named(column_between_jaws(2, 0.4, 0, 0, kTooLong)).empty());
}

TEST(PinchedGrains, LeavesABedUnderLoadToOtherChecksOfTheTimeStep) {
  constexpr double kTooLong = 2.5e-6;  // s
  EXPECT_EQ(named(column_between_jaws(60, 0.4, 0, 0.2, kTooLong)).size(), 1U);
  EXPECT_TRUE(named(column_between_jaws(70, 0.4, 0, 0.2, kTooLong)).empty());
}

TEST(PinchedGrains, LeavesGrainsBetweenToolsThatStandOrMoveTogether) {
  EXPECT_TRUE(named(column_between_jaws(2, 0.6, 0, 0)).empty());
  EXPECT_TRUE(named(column_between_jaws(2, 0.6, 0.2, 0.2)).empty());
}

// In the whole model the chain goes on to its image and ends on the same shoe.
TEST(PinchedGrains, LeavesGrainsBetweenAMovingToolAndAPlaneOfSymmetry) {
  WallBodySpec symmetry = jaw("symmetry", 0, 1, 0);
  symmetry.mirror = true;
  EXPECT_TRUE(named(column_on(symmetry, 2, 0.6, 0.2)).empty());
  constexpr double kTooLong = 2.5e-6;  // s, for the time step as well
  EXPECT_TRUE(named(column_on(symmetry, 2, 0.4, 0.2, kTooLong)).empty());
}

TEST(PinchedGrains, LeavesAnImpactOnOneWall) {
  auto settings = weightless(Model::a, {}, 1e-9);
  Simulation simulation(settings, {jaw("die", 0, 1, 0), jaw("shoe", 1, -1, 0.2)});
  NewGrain grain;
  grain.position.z() = 0.4 * settings.shape().sphere_radius;
  simulation.add_grains({grain});
  simulation.step();
  EXPECT_GT(simulation.deepest_overlap(), 0.55 * settings.shape().sphere_radius);
  EXPECT_TRUE(named(simulation).empty());
}

TEST(PinchedGrains, TakenOutByIdTheyLeaveTheOthersAndTheLedgerBalanced) {
  auto simulation = column_between_jaws(3, 0.6, 0, 0.2);
  const auto pinched = named(simulation);
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_EQ(simulation.remove_grains(std::vector<std::uint64_t>{pinched[0].id}), 1U);
  EXPECT_EQ(simulation.grains().size(), 2U);
  EXPECT_THROW(place_of(simulation, pinched[0].id), std::out_of_range);
  EXPECT_NEAR(energy_balance_error(simulation), 0, 1e-9);
  EXPECT_EQ(simulation.remove_grains(std::vector<std::uint64_t>{pinched[0].id}), 0U);
}

}  // namespace
}  // namespace diefill::engine
