// Walls far from all powder cost nothing, and leaving them out changes nothing.
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// A cloud that falls on a plate while another plate passes by far below.
Simulation cloud_over_plates(bool skip_far_walls) {
  auto settings = weightless(Model::a, {.friction = 0.5}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.skip_far_walls = skip_far_walls;
  const double size = 2 * half_size(settings.shape());
  WallBodySpec floor = plate(4 * size, 1.5e-4);
  for (auto& centre : floor.centres) centre.z() -= 1.6 * size;
  WallBodySpec passing = plate(4 * size, 1.5e-4, [](double time) {
    BodyMotion motion;
    motion.velocity.x() = 1;
    motion.translation = {time, 0, -0.02};
    return motion;
  });
  Simulation simulation(settings, {floor, passing});
  simulation.add_grains(converging_cloud({4, 4, 3}, size, 0.2, 3));
  return simulation;
}

TEST(FarWalls, CostSearchesAndChangeNothing) {
  auto skipped = cloud_over_plates(true), watched = cloud_over_plates(false);
  run_steps(skipped, 600);
  run_steps(watched, 600);
  EXPECT_GT(skipped.touching_pairs(), 0U);
  EXPECT_GT(watched.searches(), 2 * skipped.searches());
  for (std::uint64_t id = 0; id < skipped.grains().size(); ++id)
    EXPECT_LT((position_of(skipped, id) - position_of(watched, id)).norm(),
              1e-6 * half_size(skipped.settings().shape()))
        << id;
}

}  // namespace
}  // namespace diefill::engine
