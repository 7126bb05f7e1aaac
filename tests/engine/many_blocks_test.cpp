// Powder of many blocks, which are finished one by one as soon as no other needs them, comes to the same as
// powder whose blocks wait for all pairs.
#include <gtest/gtest.h>

#include "engine_test_support.h"

namespace diefill::engine {
namespace {

struct Outcome {
  std::uint64_t hash;
  Eigen::Vector3d wall_force;
  double booked;
};

/// Over a floor; where `may_sleep`, all grains are ever too fast to fall asleep, but blocks wait for all
/// pairs.
Outcome run_large_bed(int threads, bool periodic, bool may_sleep) {
  auto settings = weightless(Model::d, {.friction = 0.5, .work_of_adhesion = 0.01}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  if (may_sleep) settings.sleep.emplace().energy = 1e-12;
  const double size = 2 * half_size(settings.shape);
  if (periodic) settings.period = {34 * size, 34 * size};
  WallBodySpec floor = plate(20 * size, 4e-4);
  for (auto& centre : floor.centres) centre.z() -= 15.25 * size;
  Simulation simulation(settings, {floor});
  auto cloud = converging_cloud({33, 33, 31}, 0.98 * size, 1.5, 33);
  for (auto& grain : cloud) grain.velocity.z() -= 1.5;
  simulation.add_grains(cloud);
  EXPECT_GE(simulation.neighbours().blocks().size(), 64U);
  run_steps(simulation, 150);
  EXPECT_GT(simulation.touching_pairs(), 10000U);
  EXPECT_GT(simulation.searches(), 1U);
  EXPECT_GT(simulation.wall_load(0).force.norm(), 0);
  EXPECT_EQ(simulation.sleepers(), 0U);
  const auto& seconds = simulation.timers().seconds();
  for (const Phase phase : {Phase::contacts, Phase::gather})
    EXPECT_GT(seconds[static_cast<std::size_t>(phase)], 0);
  return {simulation.hash(), simulation.wall_load(0).force, simulation.ledger().expected()};
}

class ManyBlocks : public ::testing::TestWithParam<bool> {};

TEST_P(ManyBlocks, AreFinishedOneByOneAsTheyAreTogether) {
  const Outcome together = run_large_bed(1, GetParam(), true);
  for (const int threads : {1, 2}) {
    const Outcome one_by_one = run_large_bed(threads, GetParam(), false);
    EXPECT_EQ(one_by_one.hash, together.hash) << threads;
    EXPECT_EQ(one_by_one.wall_force, together.wall_force);
    EXPECT_EQ(one_by_one.booked, together.booked);
  }
}

INSTANTIATE_TEST_SUITE_P(OpenAndPeriodic, ManyBlocks, ::testing::Bool(),
                         [](const auto& periodic) { return periodic.param ? "Periodic" : "Open"; });

}  // namespace
}  // namespace diefill::engine
