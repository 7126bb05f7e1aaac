// Near pairs with walls are looked at only as far as their sphere has moved: no contact may be missed for it.
#include <gtest/gtest.h>

#include "engine/observe/contact_forces.h"
#include "engine/powder/rigid_motion.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kWallRadius = 1.5e-4;  // m

/// A plate that goes up and down and turns about z: its spheres pass under the grains.
BodyMotion shaking(double time) {
  const double angle = 20 * time, phase = 300 * time;
  BodyMotion motion;
  motion.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  motion.angular_velocity = {0, 0, 20};
  motion.translation = {0, 0, 2e-4 * std::sin(phase)};
  motion.velocity = {0, 0, 2e-4 * 300 * std::cos(phase)};
  return motion;
}

/// Pairs of spheres of grains and wall spheres that overlap, found by trying all.
std::size_t overlapping_pairs(const Simulation& simulation, const WallBodySpec& wall) {
  const auto& grains = simulation.grains();
  const GrainShape& shape = simulation.settings().shape();
  const BodyMotion pose = simulation.body_motion(0);
  const double reach = shape.sphere_radius + wall.sphere_radius;
  std::size_t pairs = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const Eigen::Matrix3d turn = rotation_matrix(grains.orientation_of(k));
    for (const auto& offset : shape.sphere_offsets)
      for (const auto& centre : wall.centres)
        pairs += (grains.position[k] + turn * offset - pose.point(centre)).norm() < reach;
  }
  return pairs;
}

TEST(WallRuns, MissNoContactWhileGrainsAndToolsMove) {
  auto settings = weightless(Model::d, {.friction = 0.5}, 4e-6);
  settings.gravity = {0, 0, -9.81};
  // Spheres larger than those of the wall, so that each is near many.
  settings.types = {{model_d(2 * kWallRadius, 7.63e-8 * 64)}};
  grain_contact(settings)->tangential *= 4;
  wall_contact(settings) = grain_contact(settings);
  const double size = 2 * half_size(settings.shape());
  const WallBodySpec wall = plate(5 * size, kWallRadius, shaking);
  Simulation simulation(settings, {wall});
  simulation.add_grains(converging_cloud({4, 4, 2}, 1.1 * size, 0.3, 7, {0, 0, 1.8 * size}));
  std::size_t contacts = 0;
  for (int step = 0; step < 12000; ++step) {
    simulation.step();
    if (step % 40 != 0) continue;
    std::size_t found = 0;
    visit_contact_forces(simulation,
                         [&](const ContactForce& contact) { found += contact.other == kNoGrain; });
    ASSERT_EQ(found, overlapping_pairs(simulation, wall)) << step;
    contacts += found;
  }
  EXPECT_GT(contacts, 300U);
}

}  // namespace
}  // namespace diefill::engine
