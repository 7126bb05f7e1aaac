// What size costs: between measured points by hand, and measured on a small bed.
#include "process/plan/size_cost.h"

#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
#include "process/laboratory/benchmark_bed.h"
#include "process/plan/pilot.h"

namespace diefill::process::plan {
namespace {

SizeCost measured() {
  return {{{1e3, 30e-9, 2e-7}, {1e4, 20e-9, 2e-7}, {1e6, 40e-9, 6e-7}}};
}

TEST(SizeCost, IsLinearInTheLogarithmOfTheNumber) {
  EXPECT_NEAR(measured().factor(1e5, 1e4), 1.5, 1e-12);
  EXPECT_NEAR(measured().factor(1e4, 1e5), 1 / 1.5, 1e-12);
  EXPECT_NEAR(measured().factor(1e6, 1e3), 40.0 / 30, 1e-12);
  EXPECT_NEAR(measured().search_factor(1e5, 1e4), 2, 1e-12);
}

TEST(SizeCost, StaysThatOfTheNearestPointBeyondTheEnds) {
  EXPECT_NEAR(measured().factor(1e8, 1e4), 2, 1e-12);
  EXPECT_NEAR(measured().factor(1e6, 10), 40.0 / 30, 1e-12);
  EXPECT_EQ((SizeCost{{{500, 2e-8, 1e-7}}}.factor(1e6, 500)), 1);
  EXPECT_EQ(SizeCost{}.factor(1e6, 500), 1);
}

TEST(SizeCost, MultipliesThePilotsCosts) {
  Pilot pilot;
  pilot.spheres = 10'000;
  pilot.cost[1] = {.wall_seconds = 3, .sphere_steps = 1e8, .seconds = 0.1, .whole = true};
  pilot.size = measured();
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e6), 60e-9, 1e-18);
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e5), 45e-9, 1e-18);
  // A third of it is searches, which cost three times as much there and come twice as often.
  pilot.cost[1].search_seconds = 1;
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e6), (2 * 20e-9) + (3 * 10e-9), 1e-18);
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e6, 2), (2 * 20e-9) + (6 * 10e-9), 1e-18);
  // What is beyond the powder's own 30 ns is the tools' part: half as many grains meet them there.
  pilot.cost[1].wall_seconds = 6;
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e6, 1, 0.5),
              (2 * 30e-9) + (0.5 * 20e-9) + (3 * 10e-9), 1e-18);
  // Where the pilot has too little powder for its threads, the tools' part is too dear as well.
  pilot.spheres = 1000;
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e4, 1, 0.5),
              (30e-9 + 0.5 * 20e-9) * 20 / 30 + 10e-9, 1e-18);
}

class SizeCostOf : public ::testing::TestWithParam<laboratory::BenchmarkBed> {};

TEST_P(SizeCostOf, ABedIsMeasuredSideBySide) {
  auto bed = laboratory::loose_benchmark_bed(GetParam(), 36000);
  bed.settings.threads = 2;
  engine::Simulation simulation(bed.settings, bed.walls);
  simulation.add_grains(bed.grains);
  simulation.step();
  const auto hash = simulation.hash();
  const SizeCost cost = measure_size_cost(simulation);
  EXPECT_EQ(simulation.hash(), hash);
  const double once = static_cast<double>(bed.settings.shape().spheres() * bed.grains.size());
  ASSERT_EQ(cost.points.size(), 4U);  // 6 x 6 would be more than a million
  for (std::size_t k = 0; k < 4; ++k) {
    const auto copies = static_cast<double>(k + 1);
    EXPECT_EQ(cost.points[k].spheres, once * copies * copies);
    EXPECT_GT(cost.points[k].seconds_per_sphere_step, 0);
    EXPECT_GT(cost.points[k].search_seconds, cost.points[k].seconds_per_sphere_step);
  }
  EXPECT_TRUE(measure_size_cost(engine::Simulation(bed.settings, bed.walls)).points.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Beds, SizeCostOf, ::testing::Values(laboratory::BenchmarkBed::spheres, laboratory::BenchmarkBed::clumps),
    [](const auto& kind) { return kind.param == laboratory::BenchmarkBed::spheres ? "Spheres" : "Clumps"; });

}  // namespace
}  // namespace diefill::process::plan
