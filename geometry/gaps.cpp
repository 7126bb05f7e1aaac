#include "geometry/gaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/surface_samples.h"
#include "geometry/topology.h"
#include "geometry/triangle_tree.h"

namespace diefill::geometry {

namespace {

const double kFacing = std::cos(0.5235987755982988);  // 30 degrees

std::vector<Corners> corners_with_area(const Mesh& mesh) {
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners corners = corners_of(mesh, t);
    if (!is_degenerate(corners)) triangles.push_back(corners);
  }
  return triangles;
}

bool touches(const Box& box, const Corners& corners) {
  Box own;
  for (const auto& corner : corners) own.include(corner);
  return (own.lower.array() <= box.upper.array()).all() && (own.upper.array() >= box.lower.array()).all();
}

}  // namespace

Gap measure_gap(const Mesh& one, const Mesh& other, double reach, double spacing,
                const std::function<bool(const Eigen::Vector3d&)>& elsewhere) {
  Gap gap;
  const auto others = corners_with_area(other);
  if (others.empty()) return gap;
  const TriangleTree tree(others);
  Box near = tree.box();
  near.lower.array() -= reach;
  near.upper.array() += reach;
  double narrowest = std::numeric_limits<double>::infinity();
  const auto look = [&](const SurfaceSample& sample) {
    if (!near.contains(sample.point)) return;
    const auto hit = tree.nearest(sample.point);
    if (hit.distance_squared > reach * reach) return;
    const Eigen::Vector3d facing = area_vector(tree.corners(hit.triangle)).normalized();
    if (facing.dot(sample.normal) > -kFacing) return;
    const Eigen::Vector3d across = hit.foot.point - sample.point;
    const double height = across.dot(sample.normal);
    if (height > 0 && height < kFacing * across.norm()) return;  // past an edge of the other
    const Eigen::Vector3d place = sample.point + across / 2;
    if (elsewhere && elsewhere(place)) return;
    const double width = std::max(0.0, height);
    narrowest = std::min(narrowest, width);
    if (gap.found && width <= gap.widest) return;
    gap.found = true;
    gap.widest = width;
    gap.widest_place = place;
  };
  for (const Corners& corners : corners_with_area(one))
    if (touches(near, corners)) sample_triangle(corners, spacing, look);
  if (gap.found) gap.narrowest = narrowest;
  return gap;
}

}  // namespace diefill::geometry
