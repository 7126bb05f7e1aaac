// The number of threads changes nothing but the time a run takes.
#include <gtest/gtest.h>

#include "engine_test_support.h"

namespace diefill::engine {
namespace {

struct Outcome {
  std::uint64_t hash;
  Eigen::Vector3d wall_force;
  double booked;
};

Outcome run_bed(int threads, bool periodic) {
  auto settings = weightless(Model::d, {.friction = 0.5, .work_of_adhesion = 0.01}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  const double size = 2 * half_size(settings.shape);
  if (periodic) settings.period = {10 * size, 10 * size};
  WallBodySpec floor = plate(6 * size, 1.5e-4);
  for (auto& centre : floor.centres) centre.z() -= 4.1 * size;
  Simulation simulation(settings, {floor});
  auto cloud = converging_cloud({9, 9, 8}, 0.98 * size, 0.5, 33);
  for (auto& grain : cloud) grain.velocity.z() -= 0.8;
  simulation.add_grains(cloud);
  EXPECT_GE(simulation.neighbours().blocks().size(), 3U);
  run_steps(simulation, 300);
  EXPECT_GT(simulation.touching_pairs(), 100U);
  EXPECT_GT(simulation.searches(), 3U);
  EXPECT_GT(simulation.wall_load(0).force.norm(), 0);
  return {simulation.hash(), simulation.wall_load(0).force, simulation.ledger().expected()};
}

class Threads : public ::testing::TestWithParam<bool> {};

TEST_P(Threads, GiveBitwiseTheSameBed) {
  const Outcome alone = run_bed(1, GetParam());
  for (const int threads : {2, 3}) {
    const Outcome together = run_bed(threads, GetParam());
    EXPECT_EQ(together.hash, alone.hash) << threads;
    EXPECT_EQ(together.wall_force, alone.wall_force);
    EXPECT_EQ(together.booked, alone.booked);
  }
}

INSTANTIATE_TEST_SUITE_P(OpenAndPeriodic, Threads, ::testing::Bool());

}  // namespace
}  // namespace diefill::engine
