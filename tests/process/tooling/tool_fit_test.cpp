// Tools far away or of a size that no press has: told by their place or their unit, whichever is wrong.
#include "process/tooling/tool_fit.h"

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
std::string complaint(const Eigen::Vector3d& middle, double size) {
  try {
    check_size(tool_at(middle, size), 1.5e-4, 1e-3, "tool \"die\"");
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
              "measures 2e+05 x 2e+05 x 2e+05 mm, allowed: up to 2000 mm; check whether length_unit");
  expect_says(message, "200 mm in \"um\"");
  EXPECT_EQ(message.find("origin"), std::string::npos) << message;
}

TEST(ToolFit, ATinyToolIsToldAboutItsUnit) {
  const std::string message = complaint({0, 0, 0}, 5e-5);
  expect_says(message, "too small to be covered with wall spheres; check whether length_unit");
  expect_says(message, "50 mm in \"m\"");
}

}  // namespace
}  // namespace diefill::process
