// Grains inside tools: through which surface they came in, and where the grains are far finer than the tools
// are large.
#include "process/run/lost_grains.h"

#include <gtest/gtest.h>

#include "engine/numerics/out_of_range.h"
#include "geometry/wall_spheres/wall_spheres.h"
#include "process/run/stray_watch.h"
#include "process/setup/read_tooling.h"
#include "project_paths.h"
#include "tests/process/plan/plan_sample.h"

namespace diefill::process {
namespace {

TEST(LostGrains, OfMicrometresAreLookedForInToolsOfCentimetres) {
  const Scene scene =
      read_scene(std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/laboratory/adhesive_bed.toml");
  const Tooling tooling = read_tooling(scene);
  EXPECT_NO_THROW(LostGrains(tooling, {20e-6}));
}

constexpr double kGrainDiameter = 1.2e-3;  // m
constexpr double kInterval = 1.6e-3;       // s

/// A wall of a shoe, 3 mm thick: wall spheres on all of its inner face (x = 0), on its outer face (x = 3 mm)
/// only up to 4 mm, where powder was expected.
Tooling shoe_wall() {
  Tooling tooling;
  Tool& tool = tooling.tools.emplace_back();
  tool.spec.name = "shoe";
  tool.mesh = plan::box_mesh({0, -5e-3, 0}, {3e-3, 5e-3, 20e-3});
  geometry::WallSphereOptions options;
  options.reachable = [](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    return normal.x() < -0.5 || (normal.x() > 0.5 && point.z() < 4e-3);
  };
  tool.spheres = geometry::make_wall_spheres(tool.mesh, options);
  return tooling;
}

/// A grain at `place` (m) that moves with `velocity` (m/s), and the wall.
engine::Simulation one_grain(const Tooling& tooling, const Eigen::Vector3d& place,
                             const Eigen::Vector3d& velocity) {
  engine::SimulationSettings settings;
  settings.types = {{engine::model_a(0.5 * kGrainDiameter, 5e-6)}};
  settings.time_step = 8e-6;
  engine::WallBodySpec wall;
  wall.name = tooling.tools.front().spec.name;
  wall.centres = tooling.tools.front().spheres.centres;
  wall.sphere_radius = tooling.tools.front().spheres.radius;
  engine::Simulation simulation(settings, {wall});
  engine::NewGrain grain;
  grain.position = place;
  grain.velocity = velocity;
  simulation.add_grains({grain});
  return simulation;
}

TEST(LostGrains, AGrainThatBouncedOffSpheresBesideItsEntryHasStrayed) {
  const Tooling tooling = shoe_wall();
  // Fell along the outer face half inside the wall, onto the uppermost wall spheres there: the way back along
  // its velocity leaves the wall at 3.8 mm, where wall spheres are.
  const Eigen::Vector3d place(2.38e-3, 0, 4.8e-3);
  const auto simulation = one_grain(tooling, place, {-0.089, 0.1615, 0.1335});
  const auto strayed = LostGrains(tooling, {kGrainDiameter}).strayed(simulation, kInterval);
  ASSERT_EQ(strayed.size(), 1U);
  EXPECT_EQ(strayed[0].tool, 0U);
  EXPECT_EQ(strayed[0].place, place);
}

TEST(LostGrains, AFastGrainIsTracedBackToTheWallThatItCameThrough) {
  const Tooling tooling = shoe_wall();
  // The outer face, without wall spheres at this height, is nearer; at 2 m/s it was outside 1.6 ms ago.
  const auto simulation = one_grain(tooling, {1.9e-3, 0, 10e-3}, {2, 0, 0});
  EXPECT_THROW(LostGrains(tooling, {kGrainDiameter}).strayed(simulation, kInterval), engine::OutOfRange);
}

/// What a run says of a grain that came in through the wall.
std::string complaint_of(const Tooling& tooling) {
  const auto simulation = one_grain(tooling, {1.9e-3, 0, 10e-3}, {2, 0, 0});
  try {
    LostGrains(tooling, {kGrainDiameter}).strayed(simulation, kInterval);
  } catch (const engine::OutOfRange& error) {
    return error.what();
  }
  return "";
}

TEST(LostGrains, RemedyIsThatOfTheKindOfWall) {
  Tooling tooling = shoe_wall();
  EXPECT_NE(complaint_of(tooling).find("reduce the spacing of the wall spheres"), std::string::npos);
  tooling.tools.front().wall_mesh = tooling.tools.front().mesh;
  EXPECT_NE(complaint_of(tooling).find("reduce the speed of the tool, or make"), std::string::npos);
  EXPECT_EQ(complaint_of(tooling).find("wall spheres"), std::string::npos);
}

}  // namespace
}  // namespace diefill::process
