// Samples of the surface that powder reaches, close enough together to find every hole between wall spheres.
#pragma once

#include "geometry/near_points.h"
#include "geometry/surface_samples.h"
#include "geometry/wall_cover.h"

namespace diefill::geometry {

/// Distance of surface samples over R.
inline constexpr double kSampleStep = 0.4;
/// Large triangles are looked at in parts of this length over R when only some of the surface is reachable.
inline constexpr double kPartLength = 16;
/// Distance over R of the points that stand for reachable surface when parts are passed over.
inline constexpr double kThinning = 4;

/// How near (m) one of the points that stand for reachable surface is to a part of this length (m) that
/// powder reaches.
inline double near_powder_part(double longest) {
  return (1 + kThinning / kPartLength) * longest;
}

/// Calls `visit(part)` for parts of the triangle no longer than `longest` (m) that are near one of
/// `powder_parts`.
template <typename Visit>
void visit_parts_near_powder(NearPoints& powder_parts, const Corners& corners, double longest, Visit visit) {
  const std::size_t base = longest_edge(corners);
  const Eigen::Vector3d& a = corners[base];
  const Eigen::Vector3d& b = corners[(base + 1) % 3];
  if ((b - a).norm() > longest) {
    const Eigen::Vector3d& tip = corners[(base + 2) % 3];
    const Eigen::Vector3d half = (a + b) / 2;
    visit_parts_near_powder(powder_parts, {a, half, tip}, longest, visit);
    visit_parts_near_powder(powder_parts, {half, b, tip}, longest, visit);
    return;
  }
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  if (powder_parts.any_within(middle, near_powder_part(longest))) visit(corners);
}

/// Calls `visit(sample, facet)` for the reachable samples of a stretch and, once, of the inner edges between
/// facets, kSampleStep of `depth` (m) apart.
template <typename Visit>
void sample_stretch(const CoverTarget& target, const Stretch& stretch, double depth, Visit visit) {
  /// A sample this near (over R) to a point known as reachable is reachable too.
  constexpr double kSameAnswer = 0.75;
  const double step = kSampleStep * depth;
  // What is reachable was asked once, about R apart: asking again more finely would find slivers at frayed
  // edges that no sphere was meant for.
  const double longest = kPartLength * depth;
  NearPoints near_powder(target.near_powder, kSameAnswer * depth, 3 * depth);
  NearPoints powder_parts(target.powder_parts, near_powder_part(longest), longest);
  const auto is_reachable = [&](const SurfaceSample& sample) {
    return !target.reachable || near_powder.any_within(sample.point, kSameAnswer * depth);
  };
  visit_facets(target.facets, stretch, [&](std::size_t f, std::size_t begin, std::size_t end, bool whole) {
    const Facet& facet = target.facets[f];
    const auto visit_reachable = [&](const SurfaceSample& sample) {
      if (is_reachable(sample)) visit(sample, f);
    };
    const auto sample_part = [&](const Corners& part) { sample_triangle(part, step, visit_reachable); };
    for (std::size_t place = begin; place < end; ++place) {
      const Corners corners = corners_of(target.mesh, facet.triangles[place]);
      if (target.reachable)
        visit_parts_near_powder(powder_parts, corners, longest, sample_part);
      else
        sample_part(corners);
    }
    if (!whole) return;
    for (const BorderEdge& edge : facet.border)
      if (!edge.convex && edge.other > static_cast<std::int32_t>(f))
        sample_inner_edge(edge, facet.normal, target.facets[static_cast<std::size_t>(edge.other)].normal,
                          depth, step, visit_reachable);
  });
}

}  // namespace diefill::geometry
