// Solids in a fluid: rigid, impermeable, moved by forces or as prescribed.
#include <gtest/gtest.h>

#include "tests/engine/fluid/fluid_support.h"

namespace diefill::engine {
namespace {

/// Places of the particles of solid 0, by their numbers, as seen from its centre.
std::vector<Eigen::Vector3d> arms(const FluidSimulation& simulation) {
  std::vector<Eigen::Vector3d> places;
  const Grains& particles = simulation.particles();
  for (std::uint64_t id = 0; id < simulation.solids().spec(0).shape.spheres(); ++id)
    for (std::size_t k = 0; k < particles.size(); ++k)
      if (particles.id[k] == id)
        places.push_back(particles.position[k] - simulation.solids().motion()[0].centre);
  return places;
}

TEST(RigidSets, MoveByTheirDriveAlongFreeAxesAndAsPrescribedAlongOthers) {
  FluidSimulation simulation(cube(8));
  RigidSetSpec tool;
  tool.shape = ball(1, 0.6, 2);
  tool.free = {false, false, true};
  tool.turns = false;
  tool.velocity = {0, 0.7, 0.1};
  tool.drive = {5, 5, -3};
  simulation.add_solid(tool);
  run(simulation, 100);
  const double time = 1, fall = -3 / tool.shape.mass;
  const RigidSetMotion& motion = simulation.solids().motion()[0];
  EXPECT_NEAR(motion.centre.x(), 0, 1e-12);
  EXPECT_NEAR(motion.centre.y(), 0.7 * time, 1e-12);
  EXPECT_NEAR(motion.centre.z(), 0.1 * time + 0.5 * fall * time * time, 1e-12);
  EXPECT_NEAR(motion.velocity.z(), 0.1 + fall * time, 1e-12);
}

TEST(RigidSets, KeepTheirShapeAndLetNoFluidIn) {
  constexpr double kRadius = 1.3;
  FluidSimulation simulation(cube(7));
  RigidSetSpec solid;
  solid.shape = ball(kRadius, 0.6, 1);
  simulation.add_solid(solid);
  const auto before = arms(simulation);
  const Particles all = random_fluid(1423, Eigen::Vector3d::Constant(7), 0, 2);
  Particles outside;
  for (std::size_t k = 0; k < all.places.size(); ++k)
    if (all.places[k].norm() > kRadius + 0.3) {
      outside.places.push_back(all.places[k]);
      outside.velocities.push_back(all.velocities[k]);
    }
  simulation.add_fluid(outside.places, outside.velocities);
  run(simulation, 1500);
  const auto after = arms(simulation);
  for (std::size_t k = 0; k < before.size(); ++k)
    for (std::size_t j = 0; j < k; ++j) {
      Eigen::Vector3d between = after[k] - after[j];
      for (double& part : between) part -= 7 * std::round(part / 7);
      EXPECT_NEAR(between.norm(), (before[k] - before[j]).norm(), 1e-9);
    }
  EXPECT_GT(simulation.solids().motion()[0].spin.norm(), 0);
  for (std::size_t k = 0; k < simulation.particles().size(); ++k) {
    if (!simulation.is_fluid(k)) continue;
    Eigen::Vector3d between = simulation.particles().position[k] - simulation.solids().motion()[0].centre;
    for (double& part : between) part -= 7 * std::round(part / 7);
    EXPECT_GT(between.norm(), 0.8);
  }
}

// Two grains without fluid that hit each other head on: elastic.
TEST(RigidSets, GrainsReboundElastically) {
  FluidSettings settings = cube(12);
  settings.time_step = 1e-3;
  FluidSimulation simulation(settings);
  RigidSetSpec grain;
  grain.shape = ball(1, 0.6, 1);
  for (const double side : {-1.0, 1.0}) {
    grain.centre = {1.8 * side, 0, 0};
    grain.velocity = {-0.5 * side, 0, 0};
    simulation.add_solid(grain);
  }
  run(simulation, 4000);
  for (const std::size_t s : {0U, 1U}) {
    const RigidSetMotion& motion = simulation.solids().motion()[s];
    EXPECT_NEAR(motion.velocity.x(), s == 0 ? -0.5 : 0.5, 1e-3);
    EXPECT_NEAR(motion.spin.norm(), 0, 1e-9);
  }
}

// Tools damp grains that hit them (Eq. 2.6), and do not act on each other.
TEST(RigidSets, ToolsDampGrains) {
  FluidSettings settings = cube(12);
  settings.time_step = 1e-3;
  FluidSimulation simulation(settings);
  RigidSetSpec one;
  one.shape = ball(1, 0.6, 1);
  one.tool = true;
  one.free = {false, false, false};
  one.turns = false;
  simulation.add_solid(one);
  one.centre = {0, 0.5, 0};
  simulation.add_solid(one);
  run(simulation, 5);
  for (const auto& force : simulation.particles().force) EXPECT_EQ(force.norm(), 0);
  RigidSetSpec grain;
  grain.shape = ball(1, 0.6, 1);
  grain.centre = {3.2, 0, 0};
  grain.velocity = {-0.5, 0, 0};
  simulation.add_solid(grain);
  run(simulation, 4000);
  const double rebound = simulation.solids().motion()[2].velocity.x();
  EXPECT_GT(rebound, 0.01);
  EXPECT_LT(rebound, 0.49);
}

}  // namespace
}  // namespace diefill::engine
