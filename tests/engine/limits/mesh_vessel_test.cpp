// A crowd of grains in a shaken vessel of triangles.
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "tests/engine/mesh_walls.h"

namespace diefill::engine {
namespace {

constexpr double kVesselOverSize = 3.6;  // half of its width

/// A vessel of triangles or of planes.
WallBodySpec vessel_of(bool planes, double half) {
  auto vessel = triangle_box(Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half), true);
  if (!planes) return vessel;
  vessel.triangles.clear();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      vessel.planes.push_back(
          {side * half * Eigen::Vector3d::Unit(axis), -side * Eigen::Vector3d::Unit(axis)});
  return vessel;
}

/// A crowd of clumps in a shaken vessel.
Simulation crowd(int threads, bool planes = false) {
  auto settings = weightless(Model::d, {.friction = 0.5}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  const double size = 2 * half_size(settings.shape());
  auto vessel = vessel_of(planes, kVesselOverSize * size);
  vessel.motion = [](double time) {
    BodyMotion motion;
    motion.translation.x() = 1e-4 * std::sin(2000 * time);
    motion.velocity.x() = 0.2 * std::cos(2000 * time);
    return motion;
  };
  Simulation simulation(settings, {vessel});
  auto cloud = converging_cloud({6, 6, 6}, 1.05 * size, 0.5, 3);
  for (auto& grain : cloud) grain.velocity *= -4;
  simulation.add_grains(cloud);
  return simulation;
}

TEST(MeshVessel, LosesNothing) {
  auto simulation = crowd(2), flat = crowd(2, true);
  const double size = 2 * half_size(simulation.settings().shape());
  for (int k = 0; k < 3000; ++k) {
    simulation.step();
    flat.step();
  }
  EXPECT_EQ(simulation.grains().size(), 216U);
  for (const auto& position : simulation.grains().position)
    EXPECT_LT(position.cwiseAbs().maxCoeff(), kVesselOverSize * size + 1.1e-4);
  EXPECT_LT(simulation.overlaps_of_run().walls, 0.5 * simulation.settings().shape().sphere_radius);
  EXPECT_NEAR(energy_balance_error(simulation), energy_balance_error(flat), 2e-3);
}

TEST(MeshVessel, GivesTheSameOnAnyThreadsAndAfterARestart) {
  auto alone = crowd(1), together = crowd(2);
  run_steps(alone, 1200);
  run_steps(together, 700);
  const Snapshot snapshot = together.snapshot();
  EXPECT_FALSE(snapshot.wall_history.pair.empty());
  run_steps(together, 500);
  EXPECT_EQ(together.hash(), alone.hash());
  auto resumed = crowd(2);
  resumed.restore(snapshot);
  run_steps(resumed, 500);
  EXPECT_EQ(resumed.hash(), alone.hash());
  EXPECT_EQ(resumed.wall_load(0).force, alone.wall_load(0).force);
}

}  // namespace
}  // namespace diefill::engine
