// Samples of the surface that powder reaches, close enough together to find every hole between wall spheres.
#pragma once

#include "geometry/surface_samples.h"
#include "geometry/wall_cover.h"

namespace diefill::geometry {

/// Distance of surface samples over R.
inline constexpr double kSampleStep = 0.4;
/// Large triangles are looked at in parts of this length over R when only some of the surface is reachable.
inline constexpr double kPartLength = 16;
/// Distance over R of the points that stand for reachable surface when parts are passed over.
inline constexpr double kThinning = 4;

/// Calls `visit(part)` for parts of the triangle no longer than `longest` (m) that are near powder.
template <typename Visit>
void visit_parts_near_powder(const CoverTarget& target, const Corners& corners, double longest, Visit visit) {
  const std::size_t base = longest_edge(corners);
  const Eigen::Vector3d& a = corners[base];
  const Eigen::Vector3d& b = corners[(base + 1) % 3];
  if ((b - a).norm() > longest) {
    const Eigen::Vector3d& tip = corners[(base + 2) % 3];
    const Eigen::Vector3d half = (a + b) / 2;
    visit_parts_near_powder(target, {a, half, tip}, longest, visit);
    visit_parts_near_powder(target, {half, b, tip}, longest, visit);
    return;
  }
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  const double margin = kThinning / kPartLength * longest;
  if (target.powder_parts.any_within(middle, longest + margin)) visit(corners);
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
  const auto is_reachable = [&](const SurfaceSample& sample) {
    return !target.reachable || target.near_powder.any_within(sample.point, kSameAnswer * depth);
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
        visit_parts_near_powder(target, corners, kPartLength * depth, sample_part);
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
