#include "geometry/wall_cover.h"

#include <Eigen/Geometry>
#include <cmath>
#include <deque>

#include "geometry/surface_samples.h"
#include "geometry/wall_holes.h"

namespace diefill::geometry {

namespace {

/// Distance of surface samples over R.
constexpr double kSampleStep = 0.4;
/// Nearest centre allowed to a new lattice centre, over the spacing.
constexpr double kLatticeDistance = 0.8;
constexpr int kMostPasses = 6;
/// Large triangles are looked at in parts of this length over R when only some of the surface is reachable.
constexpr double kPartLength = 16;
/// Distance over R of the points that stand for reachable surface when parts are passed over.
constexpr double kThinning = 4;

/// A sample this near (over R) to a point known as reachable is reachable too.
constexpr double kSameAnswer = 0.75;

/// Half the diagonal of a grid square, with an allowance for rounding.
double cover_distance(double spacing) {
  return spacing / std::sqrt(2.0) * (1 + 1e-6);
}

/// Calls `visit(part)` for parts of the triangle no longer than `longest` (m) that are near powder.
template <typename Visit>
void visit_parts_near_powder(const CoverTarget& target, const Corners& corners, double longest, Visit visit) {
  std::size_t base = 0;
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = (corners[(k + 1) % 3] - corners[k]).norm();
    if (side <= length) continue;
    length = side;
    base = k;
  }
  if (length > longest) {
    const Eigen::Vector3d& a = corners[base];
    const Eigen::Vector3d& b = corners[(base + 1) % 3];
    const Eigen::Vector3d& tip = corners[(base + 2) % 3];
    const Eigen::Vector3d half = (a + b) / 2;
    visit_parts_near_powder(target, {a, half, tip}, longest, visit);
    visit_parts_near_powder(target, {half, b, tip}, longest, visit);
    return;
  }
  const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  const double margin = kThinning / kPartLength * longest;
  if (target.powder_parts.nearest_within(middle, longest + margin) != PointGrid::kNone) visit(corners);
}

/// Calls `visit(sample)` for the reachable samples of a facet and of the inner edges to facets of higher
/// number.
template <typename Visit>
void sample_facet(const CoverTarget& target, std::size_t facet_index, double depth, double step,
                  Visit visit) {
  const Facet& facet = target.facets.list[facet_index];
  // What is reachable was asked once, about R apart: asking again more finely would find slivers at frayed
  // edges that no sphere was meant for.
  const auto visit_reachable = [&](const SurfaceSample& sample) {
    if (!target.reachable ||
        target.near_powder.nearest_within(sample.point, kSameAnswer * depth) != PointGrid::kNone)
      visit(sample);
  };
  const auto sample_part = [&](const Corners& part) { sample_triangle(part, step, visit_reachable); };
  for (const std::size_t triangle : facet.triangles) {
    const Corners corners = corners_of(target.mesh, triangle);
    if (target.reachable)
      visit_parts_near_powder(target, corners, kPartLength * depth, sample_part);
    else
      sample_part(corners);
  }
  for (const BorderEdge& edge : facet.border)
    if (!edge.convex && edge.other > static_cast<std::int64_t>(facet_index))
      sample_inner_edge(edge, facet.normal, target.facets.list[static_cast<std::size_t>(edge.other)].normal,
                        depth, step, visit_reachable);
}

/// Grows square lattices of centres over open surface.
class LatticeFront {
 public:
  explicit LatticeFront(WallLayout& layout) : layout_(layout) {}

  /// Grows from a centre just added; one side of the squares points along `direction`.
  void grow(const OffsetSurface::Place& seed, const Eigen::Vector3d& direction) {
    waiting_.push_back({seed, direction});
    while (!waiting_.empty()) {
      const Item item = waiting_.front();
      waiting_.pop_front();
      const Eigen::Vector3d normal = item.place.normal();
      Eigen::Vector3d ahead = item.direction - normal * normal.dot(item.direction);
      ahead = ahead.norm() > 1e-3 ? ahead.normalized() : normal.unitOrthogonal();
      const Eigen::Vector3d side = normal.cross(ahead);
      for (const Eigen::Vector3d& way : {ahead, side, Eigen::Vector3d(-ahead), Eigen::Vector3d(-side)}) {
        const Eigen::Vector3d guess = item.place.centre + layout_.spacing() * way;
        const auto added = layout_.add(guess, guess + layout_.offset().depth() * normal,
                                       kLatticeDistance * layout_.spacing());
        if (added) waiting_.push_back({*added, ahead});
      }
    }
  }

 private:
  struct Item {
    OffsetSurface::Place place;
    Eigen::Vector3d direction;
  };
  WallLayout& layout_;
  std::deque<Item> waiting_;
};

/// What was measured over a part of the surface.
struct Measured {
  double area = 0;
  double deviation_times_area = 0;
  double largest_deviation = 0;
  Eigen::Vector3d deviation_place = Eigen::Vector3d::Zero();
  double widest = 0;  ///< distance of the emptiest place from its nearest centres
  Eigen::Vector3d widest_place = Eigen::Vector3d::Zero();

  void add(const Measured& other) {
    area += other.area;
    deviation_times_area += other.deviation_times_area;
    if (other.largest_deviation > largest_deviation) {
      largest_deviation = other.largest_deviation;
      deviation_place = other.deviation_place;
    }
    if (other.widest > widest) {
      widest = other.widest;
      widest_place = other.widest_place;
    }
  }
};

/// Measures samples against the finished layout.
class Surveyor {
 public:
  explicit Surveyor(const WallLayout& layout)
      : layout_(layout), radius_(layout.offset().depth()), holes_(layout, kSampleStep * radius_) {}

  void measure(const SurfaceSample& sample, Measured& result) const {
    measure_deviation(sample, result);
    measure_gap(sample, result);
  }

 private:
  void measure_deviation(const SurfaceSample& sample, Measured& result) const {
    if (sample.area == 0) return;
    // Sharp corners may be far from every sphere; the search widens until it finds one.
    double limit = 1.6 * radius_;
    double distance = layout_.distance_to_nearest(sample.point, limit);
    while (distance >= limit && limit < kWidestSearch * radius_) {
      limit *= 2;
      distance = layout_.distance_to_nearest(sample.point, limit);
    }
    const double deviation = std::abs(distance - radius_);
    result.area += sample.area;
    result.deviation_times_area += sample.area * deviation;
    if (deviation > result.largest_deviation) {
      result.largest_deviation = deviation;
      result.deviation_place = sample.point;
    }
  }

  void measure_gap(const SurfaceSample& sample, Measured& result) const {
    const Hole hole = holes_.find(sample, std::max(radius_, result.widest));
    if (hole.distance <= result.widest) return;
    result.widest = hole.distance;
    result.widest_place = sample.point;
  }

  static constexpr double kWidestSearch = 32;
  const WallLayout& layout_;
  double radius_;
  HoleFinder holes_;
};

/// One pass over all samples. True when centres were added: they may bring a hole into a sample's view that
/// it did not see before, so that another pass is due.
bool close_holes(const CoverTarget& target, WallLayout& layout) {
  LatticeFront front(layout);
  const double radius = layout.offset().depth();
  const double step = kSampleStep * radius;
  const double allowed = cover_distance(layout.spacing());
  const HoleFinder holes(layout, step);
  const std::size_t count_before = layout.centres().points().size();
  for (std::size_t f = 0; f < target.facets.list.size(); ++f) {
    const Corners seed = corners_of(target.mesh, target.facets.list[f].triangles.front());
    const Eigen::Vector3d direction = (seed[1] - seed[0]).normalized();
    sample_facet(target, f, radius, step, [&](const SurfaceSample& sample) {
      const Hole hole = holes.find(sample, allowed);
      if (hole.distance < allowed) return;
      const auto added = layout.add(hole.middle, sample.point, (1 - 1e-3) * allowed);
      if (added) front.grow(*added, direction);
    });
  }
  return layout.centres().points().size() > count_before;
}

}  // namespace

PointGrid reachable_points(const CoverTarget& target, double step) {
  PointGrid points(2 * step);
  for (const Facet& facet : target.facets.list)
    for (const std::size_t triangle : facet.triangles)
      sample_triangle(corners_of(target.mesh, triangle), step, [&](const SurfaceSample& sample) {
        const bool known = points.nearest_within(sample.point, step / 2) != PointGrid::kNone;
        if (!known && target.reachable(sample.point, sample.normal)) points.insert(sample.point);
      });
  return points;
}

PointGrid powder_parts(const PointGrid& reachable, double radius) {
  PointGrid kept(kPartLength * radius);
  for (const Eigen::Vector3d& point : reachable.points())
    if (kept.nearest_within(point, kThinning * radius) == PointGrid::kNone) kept.insert(point);
  return kept;
}

void close_cover(const CoverTarget& target, WallLayout& layout) {
  for (int pass = 0; pass < kMostPasses; ++pass)
    if (!close_holes(target, layout)) return;
}

void measure_cover(const CoverTarget& target, const WallLayout& layout, WallSpheres& spheres) {
  const double radius = layout.offset().depth();
  const Surveyor surveyor(layout);
  Measured all;
  for (std::size_t f = 0; f < target.facets.list.size(); ++f) {
    Measured here;
    sample_facet(target, f, radius, kSampleStep * radius,
                 [&](const SurfaceSample& sample) { surveyor.measure(sample, here); });
    all.add(here);
  }
  spheres.mean_deviation = all.area > 0 ? all.deviation_times_area / all.area : 0;
  spheres.largest_deviation = all.largest_deviation;
  spheres.largest_deviation_place = all.deviation_place;
  spheres.largest_gap = 2 * std::max(0.0, all.widest - radius);
  spheres.largest_gap_place = all.widest_place;
}

}  // namespace diefill::geometry
