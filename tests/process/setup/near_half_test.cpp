// Grains of a file or of another run in a half model: those in front of the mirror plane.
#include "process/setup/near_half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/input/scene_error.h"

namespace diefill::process {
namespace {

constexpr double kSphere = 1e-4;  // m, radius

Scene half_scene() {
  Scene scene;
  scene.file = "scene.toml";
  scene.pour.line = 12;
  scene.economy.mirror = 1;
  return scene;
}

engine::SimulationSettings of_shape(const engine::GrainShape& shape) {
  engine::SimulationSettings settings;
  settings.types.front().shape = shape;
  return settings;
}

engine::NewGrain at_y(double y) {
  engine::NewGrain grain;
  grain.position = {1e-3, y, 2e-3};
  return grain;
}

TEST(NearHalf, HasTheGrainsInFrontOfThePlane) {
  const auto spheres = of_shape(engine::model_b(kSphere, 1e-8));
  const std::vector<engine::NewGrain> grains = {at_y(0.99 * kSphere), at_y(-0.99 * kSphere),
                                                at_y(5 * kSphere), at_y(-5 * kSphere)};
  const auto near = near_half(half_scene(), spheres, grains, "state");
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(near[0].position, grains[0].position);
  EXPECT_EQ(near[1].position, grains[2].position);
  EXPECT_EQ(near_half(Scene{}, spheres, grains, "state").size(), grains.size()) << "of a whole model";
}

TEST(NearHalf, RefusesAGrainThatReachesThroughThePlane) {
  const auto spheres = of_shape(engine::model_b(kSphere, 1e-8));
  try {
    near_half(half_scene(), spheres, {at_y(5 * kSphere), at_y(0.5 * kSphere)}, "grains_file");
    FAIL() << "it starts inside its own image";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    for (const char* part : {"scene.toml:12: pour.grains_file: found", "(1.00, 0.05, 2.00) mm",
                             "0.05 mm through the mirror plane y = 0", "remove economy.mirror"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(NearHalf, LooksAtTheSpheresOfAClumpAsItIsTurned) {
  const auto clumps = of_shape(engine::model_d(kSphere, 1e-8));
  engine::NewGrain grain = at_y(2.5 * kSphere);
  EXPECT_THROW(near_half(half_scene(), clumps, {grain}, "state"), SceneError);
  const double half_of_45_degrees = std::numbers::pi / 8;
  grain.orientation = {std::cos(half_of_45_degrees), 0, 0, std::sin(half_of_45_degrees)};
  EXPECT_EQ(near_half(half_scene(), clumps, {grain}, "state").size(), 1U);
}

}  // namespace
}  // namespace diefill::process
