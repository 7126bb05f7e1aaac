// Samples of the surface that powder reaches, close enough together to find every hole between wall spheres.
#pragma once

#include "geometry/grids/near_points.h"
#include "geometry/solid/surface_samples.h"
#include "geometry/wall_spheres/wall_cover.h"

namespace diefill::geometry {

/// Distance of surface samples over R.
inline constexpr double kSampleStep = 0.4;
/// Large triangles are sampled in parts of this length over R when only some of the surface is reachable.
inline constexpr double kPartLength = 16;
/// Distance over R of the points that represent the reachable surface when parts are skipped.
inline constexpr double kThinning = 4;

/// How near (m) one of the points that represent the reachable surface is to a part of this length (m) that
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

/// Which samples powder reaches. Reachability was computed once, about R apart: a finer test would find
/// slivers at frayed edges where no sphere was placed.
class ReachableSamples {
 public:
  /// For spheres of radius `depth` (m). For one thread.
  ReachableSamples(const CoverTarget& target, double depth) : target_(target), near_(kSameAnswer * depth) {}

  bool operator()(const SurfaceSample& sample) {
    if (!target_.reachable) return true;
    // What makes one sample reachable mostly does so for the next.
    const auto& points = target_.near_powder.points();
    if (last_ != PointGrid::kNone && (points[last_] - sample.point).squaredNorm() <= near_ * near_)
      return true;
    last_ = target_.near_powder.some_within(sample.point, near_);
    return last_ != PointGrid::kNone;
  }

 private:
  /// A sample this near (over R) to a point known as reachable is reachable too.
  static constexpr double kSameAnswer = 0.75;
  const CoverTarget& target_;
  double near_;  // m
  std::size_t last_ = PointGrid::kNone;
};

/// Calls `visit(sample, facet)` for the samples of a stretch near powder and, once, of the inner edges
/// between facets, kSampleStep of `depth` (m) apart. Parts of triangles for which `wanted(corners)` is false
/// are passed over; they are kPartLength of `depth` long at most where only some of the surface is reachable.
template <typename Wanted, typename Visit>
void visit_samples(const CoverTarget& target, const Stretch& stretch, double depth, Wanted wanted,
                   Visit visit) {
  const double step = kSampleStep * depth, longest = kPartLength * depth;
  NearPoints powder_parts(target.powder_parts, near_powder_part(longest), longest);
  visit_facets(target.facets, stretch, [&](std::size_t f, std::size_t begin, std::size_t end, bool whole) {
    const Facet& facet = target.facets[f];
    const auto visit_one = [&](const SurfaceSample& sample) { visit(sample, f); };
    const auto sample_part = [&](const Corners& part) {
      if (wanted(part)) sample_triangle(part, step, visit_one);
    };
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
                          depth, step, visit_one);
  });
}

/// Calls `visit(sample, facet, known)` for the reachable samples of a stretch. `known` is of all its samples:
/// empty the first time, when it is filled with whether they are reachable; visits may write what they find
/// out.
template <typename Visit>
void sample_stretch(const CoverTarget& target, const Stretch& stretch, double depth,
                    std::vector<SampleKnown>& known, Visit visit) {
  ReachableSamples reachable(target, depth);
  const bool first = known.empty();
  std::size_t number = 0;
  visit_samples(
      target, stretch, depth, [](const Corners&) { return true; },
      [&](const SurfaceSample& sample, std::size_t facet) {
        if (first) known.push_back(reachable(sample) ? SampleKnown::kReachable : SampleKnown::kBeyond);
        SampleKnown& here = known[number++];
        if (here != SampleKnown::kBeyond) visit(sample, facet, here);
      });
}

}  // namespace diefill::geometry
