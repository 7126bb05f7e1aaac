// Scenes whose tools are their meshes: what the reader keeps and refuses, and walls that repeat.
#include <gtest/gtest.h>

#include "process/powder/material.h"
#include "process/scene/walls_without_effect.h"
#include "process/tooling/periodic_tool.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

Scene scene_with(const std::string& old, const std::string& text) {
  const SceneFolder folder;
  return read_scene(folder.write(support::exchanged(faultless_scene(), old, text)));
}

TEST(MeshWallsOfScenes, AreSpheresUnlessAskedFor) {
  const SceneFolder folder;
  const Scene scene = read_scene(folder.write(faultless_scene()));
  EXPECT_EQ(scene.walls.kind, WallKind::spheres);
  EXPECT_EQ(scene.walls.contact_radius, MeshContactRadius::flat);
  for (const auto& tool : scene.tools) EXPECT_FALSE(tool.walls);
}

TEST(MeshWallsOfScenes, AreKeptForAllAndForOneTool) {
  const Scene all = scene_with("spacing = 1.6", "kind = \"mesh\"\ncontact_radius = \"wall spheres\"");
  EXPECT_EQ(all.walls.kind, WallKind::mesh);
  EXPECT_EQ(all.walls.contact_radius, MeshContactRadius::wall_spheres);
  const Scene one = scene_with("role = \"die\"", "role = \"die\"\nwalls = \"mesh\"");
  EXPECT_EQ(one.walls.kind, WallKind::spheres);
  EXPECT_EQ(one.tools.front().walls, WallKind::mesh);
  EXPECT_FALSE(one.tools.back().walls);
}

TEST(MeshWallsOfScenes, RefuseOpeningsBetweenCentresOfSpheres) {
  const SceneFolder folder;
  std::string text = support::exchanged(faultless_scene(), "spacing = 1.6", "kind = \"mesh\"");
  text = support::exchanged(text, "max_time = \"5 s\"", "opening = \"centres\"");
  try {
    read_scene(folder.write(text));
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    for (const char* part : {"numerics.opening", "tool \"die\"", "remove one of the two"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(MeshWallsOfScenes, NeedNoShorterStepForCoarseGrains) {
  const auto step_with = [](const std::string& walls) {
    const SceneFolder folder;
    std::string text = support::exchanged(faultless_scene(), "spacing = 1.6", walls);
    text = support::exchanged(text, "Distaloy AE", "ASC100.29 A2");
    return engine_settings(read_scene(folder.write(text)), 1.0).time_step;
  };
  // A sphere of 0.94 mm is pressed into dozens of wall spheres of 0.15 mm, but into few faces.
  EXPECT_GT(step_with("kind = \"mesh\""), 3 * step_with("spacing = 1.6"));
}

TEST(MeshWallsOfScenes, KeysOfTheOtherKindOfWallsAreRemarkedUpon) {
  EXPECT_TRUE(walls_without_effect(scene_with("spacing = 1.6", "spacing = 1.6")).empty());
  const auto spacing = walls_without_effect(scene_with("spacing = 1.6", "spacing = 1.6\nkind = \"mesh\""));
  ASSERT_EQ(spacing.size(), 1U);
  EXPECT_NE(spacing[0].find("walls.spacing has no effect on contacts"), std::string::npos) << spacing[0];
  const auto radius = walls_without_effect(scene_with("spacing = 1.6", "contact_radius = \"flat\""));
  ASSERT_EQ(radius.size(), 1U);
  EXPECT_NE(radius[0].find("walls.contact_radius has no effect"), std::string::npos) << radius[0];
  const auto tool =
      walls_without_effect(scene_with("role = \"die\"", "role = \"die\"\nwalls = \"mesh\"\nspacing = 2"));
  ASSERT_EQ(tool.size(), 1U);  // walls.spacing is the shoe's
  EXPECT_NE(tool[0].find("spacing of tool \"die\" has no effect"), std::string::npos) << tool[0];
}

geometry::Mesh prism() {
  geometry::Mesh mesh;
  for (const double y : {-3e-3, 3e-3})
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), {1e-3, 0}, {0, 1e-3}})
      mesh.vertices.emplace_back(corner.x(), y, corner.y());
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
  return mesh;
}

TEST(PeriodicWallMesh, ReachesBeyondBothBorders) {
  const auto fitted = periodic_wall_mesh(prism(), {{std::nullopt, 4e-3, std::nullopt}}, 1e-3, "plate");
  EXPECT_DOUBLE_EQ(fitted.bounding_box().lower.y(), -3e-3);
  EXPECT_DOUBLE_EQ(fitted.bounding_box().upper.y(), 3e-3);
  const auto longer = periodic_wall_mesh(prism(), {{std::nullopt, 5e-3, std::nullopt}}, 2e-3, "plate");
  EXPECT_DOUBLE_EQ(longer.bounding_box().upper.y(), 4.5e-3);
  EXPECT_DOUBLE_EQ(longer.bounding_box().upper.x(), 1e-3);
}

TEST(PeriodicWallMesh, StaysAsItIsWithoutPeriods) {
  const auto same = periodic_wall_mesh(prism(), {}, 1e-3, "plate");
  EXPECT_EQ(same.vertices, prism().vertices);
}

}  // namespace
}  // namespace diefill::process
