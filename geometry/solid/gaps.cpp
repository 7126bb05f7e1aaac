#include "geometry/solid/gaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/triangle_tree.h"
#include "geometry/solid/surface_samples.h"

namespace diefill::geometry {

namespace {

const double kFacing = std::cos(0.5235987755982988);  // 30 degrees

bool touches(const Box& box, const Corners& corners) {
  Box own;
  for (const auto& corner : corners) own.include(corner);
  return (own.lower.array() <= box.upper.array()).all() && (own.upper.array() >= box.lower.array()).all();
}

/// The gap seen from some triangles; `narrowest` is infinite where none was found.
Gap seen_from(std::span<const Corners> triangles, const TriangleTree& tree, const Box& near, double reach,
              double spacing, const SkipPoint& skip) {
  Gap gap;
  gap.narrowest = std::numeric_limits<double>::infinity();
  Eigen::Vector3d foot = tree.corners(0)[0];  // of the sample before, near that of the next
  const auto measure = [&](const SurfaceSample& sample) {
    if (!near.contains(sample.point)) return;
    const auto hit = tree.nearest(sample.point, (sample.point - foot).norm());
    foot = hit.foot.point;
    if (hit.distance_squared > reach * reach) return;
    const Eigen::Vector3d facing = area_vector(tree.corners(hit.triangle)).normalized();
    if (facing.dot(sample.normal) > -kFacing) return;
    const Eigen::Vector3d across = hit.foot.point - sample.point;
    const double height = across.dot(sample.normal);
    if (height > 0 && height < kFacing * across.norm()) return;  // past an edge of the other
    const Eigen::Vector3d place = sample.point + across / 2;
    if (skip && skip(sample.point, place)) return;
    const double width = std::max(0.0, height);
    gap.narrowest = std::min(gap.narrowest, width);
    if (gap.found && width <= gap.widest) return;
    gap.found = true;
    gap.widest = width;
    gap.widest_place = place;
  };
  for (const Corners& corners : triangles)
    if (touches(near, corners)) sample_triangle(corners, spacing, measure);
  return gap;
}

}  // namespace

Gap measure_gap(const SolidQuery& one, const SolidQuery& other, double reach, double spacing,
                const SkipPoint& skip) {
  const TriangleTree& tree = other.tree();
  Box near = tree.box();
  near.lower.array() -= reach;
  near.upper.array() += reach;
  const std::span<const Corners> triangles = one.tree().triangles();
  constexpr std::size_t kPart = 4096;
  std::vector<Gap> parts((triangles.size() + kPart - 1) / kPart);
  on_all_cores(parts.size(), [&](std::size_t part) {
    const auto some = triangles.subspan(part * kPart, std::min(kPart, triangles.size() - part * kPart));
    parts[part] = seen_from(some, tree, near, reach, spacing, skip);
  });
  Gap gap;
  for (const Gap& part : parts) {
    if (!part.found) continue;
    const double narrowest = gap.found ? std::min(gap.narrowest, part.narrowest) : part.narrowest;
    if (!gap.found || part.widest > gap.widest) gap = part;
    gap.narrowest = narrowest;
  }
  return gap;
}

}  // namespace diefill::geometry
