#include "process/laboratory/benchmark_bed.h"

#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"
#include "process/laboratory/benchmark_law.h"

namespace diefill::process::laboratory {
namespace {

engine::Simulation simulation_of(const BenchmarkBedState& bed) {
  engine::Simulation simulation(bed.settings, bed.walls);
  simulation.add_grains(bed.grains);
  return simulation;
}

// Copies of a periodic bed touch one another as the bed touches its own images: every figure is that of one
// bed times the number of copies.
TEST(BenchmarkBed, CopiesSideBySideAreTheSameBedManyTimes) {
  BenchmarkBedState bed = loose_benchmark_bed(BenchmarkBed::spheres, 200);
  // Neighbours press on each other, over the period's border, too.
  constexpr double kCloser = 0.94;
  for (auto& grain : bed.grains) grain.position *= kCloser;
  for (auto& period : bed.settings.period) *period *= kCloser;
  engine::Simulation one = simulation_of(bed), nine = simulation_of(side_by_side(bed, 3));
  ASSERT_EQ(nine.grains().size(), 9 * one.grains().size());
  for (int step = 0; step < 20; ++step) {
    one.step();
    nine.step();
  }
  EXPECT_GT(one.touching_pairs(), 2 * one.grains().size());
  EXPECT_EQ(nine.touching_pairs(), 9 * one.touching_pairs());
  const double energy = energy_of(one).total();
  EXPECT_NEAR(energy_of(nine).total(), 9 * energy, 1e-9 * std::abs(9 * energy));
  EXPECT_NEAR(nine.deepest_overlap(), one.deepest_overlap(), 1e-9 * one.deepest_overlap());
}

// Two spheres that meet head-on leave with the restitution of the law; adhesion takes some more.
TEST(RaceLaw, HasTheRestitutionThatItStates) {
  for (const std::string& name : benchmark_laws()) {
    if (name == "bierwisch") continue;
    BenchmarkBedState bed = loose_benchmark_bed(BenchmarkBed::spheres, 200);
    set_benchmark_law(bed, name);
    bed.settings.gravity = Eigen::Vector3d::Zero();
    bed.settings.time_step = 2e-7;
    bed.walls.clear();
    bed.grains.resize(2);
    constexpr double kRadius = 1.5e-4, kSpeed = 0.5;
    for (std::size_t k = 0; k < 2; ++k) {
      const double side = k == 0 ? -1 : 1;
      bed.grains[k].position = {side * 1.01 * kRadius, 0, 0};
      bed.grains[k].velocity = {-side * kSpeed, 0, 0};
    }
    engine::Simulation simulation = simulation_of(bed);
    for (int step = 0; step < 2000; ++step) simulation.step();
    const double restitution = simulation.grains().velocity[1].x() / kSpeed;
    EXPECT_LT(restitution, 0.505) << name;
    EXPECT_GT(restitution, name == "jkr" ? 0.4 : 0.495) << name;
  }
}

}  // namespace
}  // namespace diefill::process::laboratory
