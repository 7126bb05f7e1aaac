// The number of threads changes nothing but the time a run takes; nor does it matter whether blocks are
// finished one by one, as soon as no other needs them, or all together when all pairs are computed.
#include <gtest/gtest.h>

#include "engine/observe/powder_figures.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// Grains in a lattice that fall on a floor; lengths in grain sizes.
struct Bed {
  int across, along, high;  ///< grains
  double period, floor_half_width, floor_depth;
  double wall_sphere_radius;        ///< m
  double random_speed, fall_speed;  ///< m/s
  int steps;
  std::size_t least_blocks;
  std::uint64_t least_touching, least_searches;
};

constexpr Bed kSmall{9, 9, 8, 10, 6, 4.1, 1.5e-4, 0.5, 0.8, 300, 3, 100, 3};
/// Of so many blocks that they are finished one by one where nobody can fall asleep.
constexpr Bed kLarge{33, 33, 31, 34, 20, 15.25, 4e-4, 1.5, 1.5, 150, 64, 10000, 1};

struct Outcome {
  std::uint64_t hash;
  Eigen::Vector3d wall_force;
  double booked;
};

/// Where grains `may_sleep`, all are ever too fast to do so.
Outcome run_bed(const Bed& bed, int threads, bool periodic, bool may_sleep) {
  auto settings = weightless(Model::d, {.friction = 0.5, .work_of_adhesion = 0.01}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  if (may_sleep) settings.sleep.emplace().energy = 1e-12;
  const double size = 2 * half_size(settings.shape());
  if (periodic) settings.period = {bed.period * size, bed.period * size};
  WallBodySpec floor = plate(bed.floor_half_width * size, bed.wall_sphere_radius);
  for (auto& centre : floor.centres) centre.z() -= bed.floor_depth * size;
  Simulation simulation(settings, {floor});
  auto cloud = converging_cloud({bed.across, bed.along, bed.high}, 0.98 * size, bed.random_speed, 33);
  for (auto& grain : cloud) grain.velocity.z() -= bed.fall_speed;
  simulation.add_grains(cloud);
  EXPECT_GE(simulation.neighbours().blocks().size(), bed.least_blocks);
  run_steps(simulation, bed.steps);
  EXPECT_GT(simulation.touching_pairs(), bed.least_touching);
  EXPECT_GT(simulation.searches(), bed.least_searches);
  EXPECT_GT(simulation.wall_load(0).force.norm(), 0);
  EXPECT_EQ(sleepers(simulation), 0U);
  const auto& seconds = simulation.timers().seconds();
  for (const Phase phase : {Phase::contacts, Phase::gather})
    EXPECT_GT(seconds[static_cast<std::size_t>(phase)], 0);
  return {simulation.hash(), simulation.wall_load(0).force, simulation.ledger().expected()};
}

void expect_same(const Outcome& one, const Outcome& other, int threads) {
  EXPECT_EQ(one.hash, other.hash) << threads;
  EXPECT_EQ(one.wall_force, other.wall_force);
  EXPECT_EQ(one.booked, other.booked);
}

class Threads : public ::testing::TestWithParam<bool> {};

TEST_P(Threads, GiveBitwiseTheSameBed) {
  const Outcome alone = run_bed(kSmall, 1, GetParam(), false);
  for (const int threads : {2, 3}) expect_same(run_bed(kSmall, threads, GetParam(), false), alone, threads);
}

TEST_P(Threads, FinishManyBlocksOneByOneAsTheyDoTogether) {
  const Outcome together = run_bed(kLarge, 1, GetParam(), true);
  for (const int threads : {1, 2})
    expect_same(run_bed(kLarge, threads, GetParam(), false), together, threads);
}

INSTANTIATE_TEST_SUITE_P(OpenAndPeriodic, Threads, ::testing::Bool());

}  // namespace
}  // namespace diefill::engine
