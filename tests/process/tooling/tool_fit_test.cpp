// Tools far away or of a size that no press has: told by their place or their unit, whichever is wrong.
#include "process/tooling/examination/tool_fit.h"

#include <gtest/gtest.h>

namespace diefill::process {
namespace {

/// A tetrahedron's mesh of that size about `middle`, m.
geometry::Mesh tool_at(const Eigen::Vector3d& middle, double size) {
  geometry::Mesh mesh;
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(-0.5, -0.5, -0.5), {0.5, 0.5, -0.5}, {-0.5, 0.5, 0.5}, {0.5, -0.5, 0.5}})
    mesh.vertices.push_back(middle + size * corner);
  mesh.triangles = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

/// What is said of a tool of that `size` (m) at `middle`, in mm; nothing where it is taken.
std::string complaint(const Eigen::Vector3d& middle, double size, bool file_states_unit = false) {
  try {
    check_size(tool_at(middle, size), {1.5e-4}, {1e-3, file_states_unit}, "tool \"die\"");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

void expect_says(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "missing: " << words << "\nin: " << text;
}

TEST(ToolFit, OnlyAxesThatAreFarAreToBeMoved) {
  expect_says(complaint({30, 0.31, -0.12}, 0.1), "is 30 m from the origin, allowed: up to 20 m");
  expect_says(complaint({30, 0.31, -0.12}, 0.1), "add [\"-30000 mm\", \"0 mm\", \"0 mm\"] to its position");
  expect_says(complaint({3, -25.5, 0.12}, 0.1), "add [\"-3000 mm\", \"25500 mm\", \"0 mm\"] to its position");
}

TEST(ToolFit, ToolsWithinTwentyMetresAreTaken) {
  EXPECT_EQ(complaint({19.9, -19.9, 19.9}, 0.1), "");
  EXPECT_EQ(complaint({0, 0, 0}, 1.9), "");
}

TEST(ToolFit, AHugeToolIsToldAboutItsUnitAndNotItsDistance) {
  const std::string message = complaint({100, 100, 0}, 200);
  expect_says(message,
              "measures 200000 x 200000 x 200000 mm, allowed: up to 2000 mm; check whether length_unit");
  expect_says(message, "200 mm in \"um\"");
  EXPECT_EQ(message.find("origin"), std::string::npos) << message;
}

TEST(ToolFit, ATinyToolIsToldAboutItsUnit) {
  const std::string message = complaint({0, 0, 0}, 5e-5);
  expect_says(message, "too small to be covered with wall spheres; check whether length_unit");
  expect_says(message, "50 mm in \"m\"");
}

TEST(ToolFit, WhereTheFileStatesItsUnitLengthUnitIsNotTheRemedy) {
  for (const double size : {200.0, 5e-5}) {
    const std::string message = complaint({0, 0, 0}, size, true);
    expect_says(message, "its CAD file states its unit: export it again in the unit that it is drawn in (");
    EXPECT_EQ(message.find("length_unit"), std::string::npos) << message;
  }
}

/// What is said of a tool of that `size` (m) with wall spheres of that radius; nothing where it is taken.
std::string complaint_of_radius(double size, const WallRadius& radius) {
  try {
    check_size(tool_at({0, 0, 0}, size), radius, {1e-3, false}, "scene.toml:8: tool \"die\"");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(ToolFit, ARadiusThatIsTooLargeForAToolIsToldByItsKey) {
  const std::string message = complaint_of_radius(0.0166, {0.01});
  expect_says(
      message,
      "scene.toml:8: tool \"die\": walls.sphere_radius is 10 mm, allowed for this tool: 0.001 mm to 4.15 "
      "mm, a quarter of its longest side; the tool measures 16.6 x 16.6 x 16.6 mm");
  EXPECT_EQ(message.find("length_unit"), std::string::npos) << message;
  expect_says(complaint_of_radius(0.0166, {0.005, "its sphere_radius"}),
              "its sphere_radius is 5 mm, allowed");
  EXPECT_EQ(complaint_of_radius(0.0166, {0.0041}), "");
  // A die of 74 mm whose file in inches is taken for one in millimetres.
  const std::string doubtful = complaint_of_radius(0.0029, {0.001});
  expect_says(doubtful, "walls.sphere_radius is 1 mm, allowed for this tool: 0.001 mm to 0.725 mm");
  expect_says(doubtful,
              "or check whether length_unit is that of the CAD file (29 mm in \"cm\", 73.66 mm in \"inch\")");
}

/// A tool of that name whose mesh is that of `size` (m) about `middle`.
void make_tool(Tool& tool, const std::string& name, const Eigen::Vector3d& middle, double size) {
  tool.spec.name = name;
  tool.mesh = tool_at(middle, size);
}

/// What is said of two tools; nothing where they fit.
std::string said_of(const Tool& one, const Tool& other) {
  try {
    check_fit(one, other, 1.5e-4, "scene.toml:9: tool \"" + one.spec.name + "\"");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(ToolFit, TheSameBodyTwiceAtOnePlaceIsRefused) {
  Tool die, again, beside;
  make_tool(die, "die", {0, 0, 0}, 0.02);
  make_tool(again, "die 2", {0, 0, 0}, 0.02);
  make_tool(beside, "die 3", {0.03, 0, 0}, 0.02);
  const std::string message = said_of(again, die);
  expect_says(message, "scene.toml:9: tool \"die 2\" and tool \"die\" are the same body at the same place");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_EQ(said_of(beside, die), "");
}

TEST(ToolFit, ABodyThatAnotherToolsFileHoldsTooIsRefused) {
  Tool press, core;
  make_tool(press, "press", {0, 0, 0}, 0.02);
  make_tool(core, "core", {0.05, 0, 0}, 0.01);
  const int corners = static_cast<int>(press.mesh.vertices.size());
  for (const auto& corner : core.mesh.vertices) press.mesh.vertices.push_back(corner);
  for (const auto& triangle : core.mesh.triangles)
    press.mesh.triangles.emplace_back(triangle.array() + corners);
  expect_says(said_of(core, press), "are the same body at the same place");
  expect_says(said_of(press, core), "are the same body at the same place");
}

}  // namespace
}  // namespace diefill::process
