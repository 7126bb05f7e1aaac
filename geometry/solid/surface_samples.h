// Points on a triangulated surface, each with its share of the area.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/mesh/surface_facets.h"
#include "geometry/mesh/triangle.h"

namespace diefill::geometry {

/// A point of the surface.
struct SurfaceSample {
  Eigen::Vector3d point;   ///< m
  Eigen::Vector3d normal;  ///< unit length, out of the solid
  double area = 0;         ///< m^2 it stands for; 0 on edges
  /// The place straight below, `depth` (m) into the solid.
  Eigen::Vector3d at_depth(double depth) const { return point - depth * normal; }
};

/// Calls `visit(sample)` for points in columns on the triangle's longest edge, at most `step` (m) apart;
/// their areas add up to the triangle's.
template <typename Visit>
void sample_triangle(const Corners& corners, double step, Visit visit) {
  const std::size_t base = longest_edge(corners);
  const Eigen::Vector3d& a = corners[base];
  const Eigen::Vector3d& b = corners[(base + 1) % 3];
  const Eigen::Vector3d& tip = corners[(base + 2) % 3];
  const double longest = (b - a).norm();
  const Eigen::Vector3d area = area_vector(corners);
  const Eigen::Vector3d normal = area.normalized();
  const Eigen::Vector3d along = (b - a) / longest, up = normal.cross(along);
  const double height = (tip - a).dot(up), foot = std::clamp((tip - a).dot(along), 0.0, longest);
  const auto height_at = [&](double x) {
    return height * (x < foot ? x / foot : x < longest ? (longest - x) / (longest - foot) : 0.0);
  };
  // Area of the triangle before x along its longest side.
  const auto area_before = [&](double x) {
    return x < foot ? 0.5 * x * height_at(x) : 0.5 * (longest * height - (longest - x) * height_at(x));
  };
  // Columns on the longest side, so that thin triangles are sampled to their tips: many may meet there.
  const int columns = std::max(1, static_cast<int>(std::ceil(longest / step)));
  for (int column = 0; column < columns; ++column) {
    const double begin = longest * column / columns, end = longest * (column + 1) / columns;
    const double middle = 0.5 * (begin + end), top = height_at(middle);
    const int count = std::max(1, static_cast<int>(std::ceil(top / step)));
    const double share = (area_before(end) - area_before(begin)) / count;
    for (int i = 0; i < count; ++i)
      visit(SurfaceSample{a + middle * along + ((i + 0.5) / count * top) * up, normal, share});
  }
}

/// Calls `visit(sample)` for points along an edge that is not convex and normals in between those of its two
/// faces, at most `step` (m) apart at depth `depth` (m): the spheres of an inner corner lie on an arc about
/// the edge.
template <typename Visit>
void sample_inner_edge(const BorderEdge& edge, const Eigen::Vector3d& normal,
                       const Eigen::Vector3d& other_normal, double depth, double step, Visit visit) {
  const int along = std::max(1, static_cast<int>(std::ceil((edge.to() - edge.from()).norm() / step)));
  const int round = static_cast<int>(std::ceil(depth * edge.angle / step));
  for (int j = 1; j < round; ++j) {
    const double t = static_cast<double>(j) / round;
    const Eigen::Vector3d between =
        ((std::sin((1 - t) * edge.angle) * normal + std::sin(t * edge.angle) * other_normal) /
         std::sin(edge.angle))
            .normalized();
    for (int i = 0; i < along; ++i)
      visit(SurfaceSample{edge.from() + ((i + 0.5) / along) * (edge.to() - edge.from()), between, 0});
  }
}

}  // namespace diefill::geometry
