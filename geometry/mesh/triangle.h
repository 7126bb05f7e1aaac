// One triangle: its closest point to a query, and which feature (corner, edge, face) that point is on.
#pragma once

#include <Eigen/Core>
#include <array>

namespace diefill::geometry {

/// Corners of a triangle, counter-clockwise seen from outside.
using Corners = std::array<Eigen::Vector3d, 3>;

/// Where on a triangle a closest point lies. Edge k runs from corner k to corner (k + 1) % 3.
struct TriangleFeature {
  enum class Kind { kCorner, kEdge, kFace };
  Kind kind = Kind::kFace;
  int index = 0;  ///< of the corner or edge
};

/// Closest point of a triangle, m.
struct TriangleFoot {
  Eigen::Vector3d point;
  TriangleFeature feature;
};

/// The point of the triangle closest to `query` (m), by Voronoi regions of its features (Ericson 2005,
/// section 5.1.5). Everything is computed relative to the query's neighbourhood, so that the distance keeps
/// its digits.
TriangleFoot closest_point(const Corners& corners, const Eigen::Vector3d& query);

/// The edge of greatest length, the first of several.
std::size_t longest_edge(const Corners& corners);

/// Twice the area times the unit normal, m^2.
Eigen::Vector3d area_vector(const Corners& corners);

/// True when the triangle has practically no area: its height is below 1e-12 of its longest edge.
bool is_degenerate(const Corners& corners);

}  // namespace diefill::geometry
