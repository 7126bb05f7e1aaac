// What tests of wall spheres ask of them: their depth, the gaps between them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/solid/solid_query.h"
#include "geometry/wall_spheres/wall_spheres.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry::wall_sphere_tests {

inline constexpr double kRadius = 1.5e-4;
inline constexpr double kSpacing = 1.6 * kRadius;

inline WallSphereOptions options() {
  WallSphereOptions result;
  result.radius = kRadius;
  return result;
}

/// Diameter of the hole in the middle of four spheres on a square grid.
inline double square_grid_gap(double spacing_over_radius) {
  return 2 * kRadius * (spacing_over_radius / std::sqrt(2) - 1);
}

/// Every centre is inside, and neither closer to the surface than R nor deeper.
inline void expect_all_at_depth(const Mesh& mesh, const WallSpheres& spheres) {
  const SolidQuery query(mesh);
  double shallowest = 1;
  double deepest = 0;
  for (const Eigen::Vector3d& centre : spheres.centres) {
    const double depth = -query.signed_distance(centre);
    shallowest = std::min(shallowest, depth);
    deepest = std::max(deepest, depth);
  }
  EXPECT_GE(shallowest, kRadius * (1 - 1e-9));
  EXPECT_NEAR(shallowest, kRadius, 1e-12);
  EXPECT_NEAR(deepest, kRadius, 1e-12);
}

/// The widest place without a sphere along a line of points at depth R: the brute-force answer to "does it
/// leak".
inline double widest_along(const WallSpheres& spheres, const Eigen::Vector3d& from,
                           const Eigen::Vector3d& to) {
  double widest = 0;
  for (int i = 0; i <= 400; ++i) {
    const Eigen::Vector3d place = from + i / 400.0 * (to - from);
    double nearest = 1;
    for (const Eigen::Vector3d& centre : spheres.centres)
      nearest = std::min(nearest, (centre - place).norm());
    widest = std::max(widest, nearest);
  }
  return widest;
}

inline double area(const Mesh& mesh) {
  double sum = 0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
    sum += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return sum;
}

}  // namespace diefill::geometry::wall_sphere_tests
