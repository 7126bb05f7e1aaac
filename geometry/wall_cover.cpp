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
  if (target.powder_parts.any_within(middle, longest + margin)) visit(corners);
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
    if (!target.reachable || target.near_powder.any_within(sample.point, kSameAnswer * depth)) visit(sample);
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
    const double least = std::max(radius_, result.widest);
    if (holes_.covered(sample, least)) return;
    const Hole hole = holes_.find(holes_.below(sample), least);
    if (hole.distance <= result.widest) return;
    result.widest = hole.distance;
    result.widest_place = sample.point;
  }

  static constexpr double kWidestSearch = 32;
  const WallLayout& layout_;
  double radius_;
  HoleFinder holes_;
};

/// Fills holes with centres, sample by sample. New centres may bring a hole into a sample's view that it did
/// not see before, so that further passes are due; they look again only where a centre came into view.
class HoleCloser {
 public:
  HoleCloser(const CoverTarget& target, WallLayout& layout)
      : target_(target),
        layout_(layout),
        front_(layout),
        holes_(layout, kSampleStep * layout.offset().depth()),
        allowed_(cover_distance(layout.spacing())),
        begun_(count()),
        noted_(count()),
        new_centres_(holes_.sight()) {}

  /// True when centres were added.
  bool first_pass() {
    const double radius = layout_.offset().depth();
    begin_pass();
    for (std::size_t f = 0; f < target_.facets.list.size(); ++f)
      sample_facet(target_, f, radius, kSampleStep * radius, [&](const SurfaceSample& sample) {
        if (holes_.covered(sample, allowed_)) return;  // and will be, as centres only come
        open_.push_back({sample, holes_.below(sample), f});
        close(open_.back());
      });
    return count() > begun_;
  }

  /// True when centres were added.
  bool next_pass() {
    begin_pass();
    for (const OpenSample& open : open_) {
      const double aside = (open.sample.at_depth(layout_.offset().depth()) - open.place).norm();
      if (!new_centres_.any_within(open.place, holes_.sight() + aside)) continue;
      if (!holes_.covered(open.sample, allowed_)) close(open);
      note_new_centres();
    }
    return count() > begun_;
  }

 private:
  /// A sample where there may be a hole.
  struct OpenSample {
    SurfaceSample sample;
    Eigen::Vector3d place;  ///< at depth R
    std::size_t facet;
  };

  std::size_t count() const { return layout_.centres().points().size(); }

  /// The centres of the pass before are new to every sample, those of the pass that begins to the ones to
  /// come.
  void begin_pass() {
    new_centres_ = PointGrid(holes_.sight());
    noted_ = begun_;
    begun_ = count();
    note_new_centres();
  }
  void note_new_centres() {
    for (; noted_ < count(); ++noted_) new_centres_.insert(layout_.centres().points()[noted_]);
  }

  void close(const OpenSample& open) {
    const Hole hole = holes_.find(open.place, allowed_);
    if (hole.distance < allowed_) return;
    const auto added = layout_.add(hole.middle, open.sample.point, (1 - 1e-3) * allowed_);
    if (!added) return;
    const Corners corners = corners_of(target_.mesh, target_.facets.list[open.facet].triangles.front());
    front_.grow(*added, (corners[1] - corners[0]).normalized());
  }

  const CoverTarget& target_;
  WallLayout& layout_;
  LatticeFront front_;
  HoleFinder holes_;
  double allowed_;
  std::vector<OpenSample> open_;
  std::size_t begun_;      ///< centres there were when the pass began
  std::size_t noted_;      ///< of the centres, those already in new_centres_ or too old for it
  PointGrid new_centres_;  ///< those that came since a sample was looked at last, and a few more
};

}  // namespace

PointGrid reachable_points(const CoverTarget& target, double step) {
  PointGrid points(2 * step);
  for (const Facet& facet : target.facets.list)
    for (const std::size_t triangle : facet.triangles)
      sample_triangle(corners_of(target.mesh, triangle), step, [&](const SurfaceSample& sample) {
        const bool known = points.any_within(sample.point, step / 2);
        if (!known && target.reachable(sample.point, sample.normal)) points.insert(sample.point);
      });
  return points;
}

PointGrid powder_parts(const PointGrid& reachable, double radius) {
  PointGrid kept(kPartLength * radius);
  for (const Eigen::Vector3d& point : reachable.points())
    if (!kept.any_within(point, kThinning * radius)) kept.insert(point);
  return kept;
}

void close_cover(const CoverTarget& target, WallLayout& layout) {
  HoleCloser closer(target, layout);
  bool added = closer.first_pass();
  for (int pass = 1; added && pass < kMostPasses; ++pass) added = closer.next_pass();
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
