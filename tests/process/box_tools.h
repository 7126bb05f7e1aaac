// Tools made of boxes, and the scene of the sample ring with them in place of its CAD files.
#pragma once

#include <utility>

#include "process/tooling/tooling.h"
#include "tests/process/scene_files.h"
#include "tests/support/scene_text.h"

namespace diefill::process {

/// Adds a box, closed and outward.
inline void add_box(geometry::Mesh& mesh, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  const auto first = static_cast<int>(mesh.vertices.size());
  for (int k = 0; k < 8; ++k)
    mesh.vertices.emplace_back((k & 1) != 0 ? upper[0] : lower[0], (k & 2) != 0 ? upper[1] : lower[1],
                               (k & 4) != 0 ? upper[2] : lower[2]);
  for (const Eigen::Vector3i& side : {Eigen::Vector3i(0, 2, 1),
                                      {1, 2, 3},
                                      {4, 5, 6},
                                      {5, 7, 6},
                                      {0, 1, 4},
                                      {1, 5, 4},
                                      {2, 6, 3},
                                      {3, 6, 7},
                                      {0, 4, 2},
                                      {2, 4, 6},
                                      {1, 3, 5},
                                      {3, 7, 5}})
    mesh.triangles.emplace_back(side + Eigen::Vector3i::Constant(first));
}

inline geometry::Mesh box_of(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  geometry::Mesh mesh;
  add_box(mesh, lower, upper);
  return mesh;
}

/// Four walls, 2 mm thick, from z = 0 to `height` (m) around the pour box of the sample scene: x from 19.4 to
/// 51.4 mm, y from -14.5 to 14.5 mm.
inline geometry::Mesh walls_around_the_pour(double height) {
  const double left = 19.4e-3, right = 51.4e-3, half = 14.5e-3, wall = 2e-3;
  geometry::Mesh mesh;
  add_box(mesh, {left - wall, -half - wall, 0}, {left, half + wall, height});
  add_box(mesh, {right, -half - wall, 0}, {right + wall, half + wall, height});
  add_box(mesh, {left, -half - wall, 0}, {right, -half, height});
  add_box(mesh, {left, half, 0}, {right, half + wall, height});
  return mesh;
}

/// The scene with a die and a shoe.
struct BoxTools {
  explicit BoxTools(geometry::Mesh die, geometry::Mesh shoe, const support::SceneTables& tables = {})
      : scene(read_scene(folder.write(support::scene_text(tables)))) {
    tooling.tools.resize(2);
    tooling.tools[0].mesh = std::move(die);
    tooling.tools[1].mesh = std::move(shoe);
    for (std::size_t k = 0; k < 2; ++k) tooling.tools[k].spec = scene.tools[k];
  }

  SceneFolder folder;
  Scene scene;
  Tooling tooling;
};

/// Tables of the scene with these steps, which need no preparing.
inline support::SceneTables with_steps(const std::string& steps) {
  support::SceneTables tables;
  tables.steps = steps;
  return tables;
}

/// A table of 120 x 60 mm about the origin, its top at z = 0.
inline geometry::Mesh table() {
  return box_of({-0.06, -0.03, -0.03}, {0.06, 0.03, 0});
}

}  // namespace diefill::process
