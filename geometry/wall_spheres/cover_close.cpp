#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/wall_spheres/cover_samples.h"
#include "geometry/wall_spheres/wall_holes.h"

namespace diefill::geometry {

namespace {

/// Nearest centre allowed to a new lattice centre, over the spacing.
constexpr double kLatticeDistance = 0.8;
constexpr int kMaxPasses = 6;

/// Half the diagonal of a grid square, with an allowance for rounding.
double cover_distance(double spacing) {
  return spacing / std::sqrt(2.0) * (1 + 1e-6);
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

/// New centres, by the samples that they may affect. `lateral` (m) is the largest distance of samples' places
/// from straight below.
class NewCentres {
 public:
  NewCentres(const HoleFinder& holes, double radius)
      : radius_of_influence_(holes.influence_radius()),
        radius_(radius),
        near_(radius_of_influence_),
        far_(kFar * radius_of_influence_) {}

  void clear() {
    near_ = PointGrid(radius_of_influence_);
    far_ = PointGrid(kFar * radius_of_influence_);
  }
  void insert(const Eigen::Vector3d& centre) {
    near_.insert(centre);
    far_.insert(centre);
  }
  /// Whether one of them may change the hole round the sample's place.
  bool affects(const SurfaceSample& sample, const Eigen::Vector3d& place) const {
    if (near_.points().empty()) return false;
    return near_.any_within(place, radius_of_influence_ + (sample.at_depth(radius_) - place).norm());
  }
  /// The same, in doubt true, before the place is known.
  bool may_affect(const SurfaceSample& sample, double lateral) const {
    return !near_.points().empty() && grid(lateral).any_within(sample.at_depth(radius_), reach(lateral));
  }
  /// The same for samples anywhere in a box.
  bool may_affect(const Box& box, double lateral) const {
    const double farthest = reach(lateral) + radius_;
    return std::any_of(near_.points().begin(), near_.points().end(), [&](const Eigen::Vector3d& centre) {
      const Eigen::Vector3d beyond = (box.lower - centre).cwiseMax(centre - box.upper).cwiseMax(0);
      return beyond.squaredNorm() <= farthest * farthest;
    });
  }
  /// The same for samples of a part, by a query of near_parts().
  bool may_affect(const Corners& part, double lateral, NearPoints& near_parts) const {
    if (near_.points().empty()) return false;
    const Eigen::Vector3d middle = (part[0] + part[1] + part[2]) / 3;
    double farthest = 0;
    for (const Eigen::Vector3d& corner : part) farthest = std::max(farthest, (corner - middle).norm());
    return near_parts.any_within(middle, farthest + radius_ + reach(lateral));
  }
  NearPoints near_parts(double lateral) const {
    return {far_, kPartLength * radius_ + reach(lateral), kPartLength * radius_};
  }

 private:
  static constexpr double kFar = 6, kRounding = 1e-9;
  /// Distance up to which a centre affects a place: more where the place is not straight below.
  double reach(double lateral) const { return (radius_of_influence_ + 2 * lateral) * (1 + kRounding); }
  const PointGrid& grid(double lateral) const { return 2 * lateral < radius_of_influence_ ? near_ : far_; }

  double radius_of_influence_, radius_;  // m
  PointGrid near_, far_;                 ///< the same centres in small and in large cells
};

/// Fills holes with centres, sample by sample. New centres may change the hole that belongs to a sample,
/// so that further passes are due; they check only samples that a new centre may affect. All cores search for
/// holes, in turns with filling those found: a result is valid until a new centre affects it, so that the
/// outcome is that of checking one sample after the other.
class HoleCloser {
 public:
  HoleCloser(const CoverTarget& target, WallLayout& layout)
      : target_(target),
        layout_(layout),
        front_(layout),
        holes_(layout, kSampleStep * layout.offset().depth()),
        allowed_(cover_distance(layout.spacing())),
        fresh_(holes_, layout.offset().depth()),
        since_check_(fresh_),
        known_(target.stretches.size()),
        lateral_(target.stretches.size(), 0) {}

  /// True when centres were added.
  bool pass() {
    const std::size_t before = count();
    if (first_)
      check_all();
    else
      recheck_all();
    fresh_.clear();
    for (std::size_t i = before; i < count(); ++i) fresh_.insert(layout_.centres().points()[i]);
    first_ = false;
    return count() > before;
  }

  SamplesKnown take_known() { return std::move(known_); }

 private:
  /// The result for a sample that no centre covers.
  struct SampleResult {
    SurfaceSample sample;
    std::uint32_t facet = 0;
    std::optional<Eigen::Vector3d> place;  ///< at depth R; none where it was not searched or is none
    bool too_thin = false;                 ///< none: a fault only if the sample is not covered in the end
    bool hole = false;                     ///< there was one
    std::size_t centres = 0;               ///< there were
  };

  /// Whether samples of a stretch may have a hole that they did not have before.
  struct StretchResult {
    const Stretch* stretch = nullptr;
    bool hole = false;        ///< one has, or the solid is too thin there
    Box box;                  ///< round its parts near powder, m
    std::size_t centres = 0;  ///< there were
  };

  std::size_t count() const { return layout_.centres().points().size(); }

  void check_all() {
    StretchProgress progress(target_, kHolesBegin, kRepeatPassesBegin);
    work_and_take(
        target_.stretches, [&](const Stretch& stretch) { return check_stretch(stretch); },
        [&](const std::vector<SampleResult>& results) {
          progress.next();
          for (const SampleResult& result : results) {
            forget_before(result.centres);
            apply(result);
            note_new();
          }
        });
  }

  /// One thread at a time checks a stretch; it alone writes what is known of it.
  std::vector<SampleResult> check_stretch(const Stretch& stretch) {
    const double radius = layout_.offset().depth();
    HoleFinder holes = holes_;
    std::vector<SampleResult> results;
    sample_stretch(
        target_, stretch, radius, known_[stretch.number],
        [&](const SurfaceSample& sample, std::size_t facet, SampleKnown& known_here) {
          if (holes.covered(sample, allowed_)) {
            known_here = SampleKnown::kCovered;
            return;
          }
          results.push_back({sample, static_cast<std::uint32_t>(facet), {}, false, false, count()});
          evaluate(results.back(), holes);
          const double lateral = lateral_offset_of(results.back());
          if (lateral == 0) known_here = SampleKnown::kStraightBelow;
          lateral_[stretch.number] = std::max(lateral_[stretch.number], lateral);
        });
    return results;
  }

  void evaluate(SampleResult& result, HoleFinder& holes) const {
    try {
      result.place = holes.below(result.sample);
      result.hole = result.place && holes.find(result.sample, *result.place, allowed_).distance >= allowed_;
    } catch (const MeshError&) {
      result.too_thin = true;
    }
  }

  /// m, how far the sample's place is from straight below.
  double lateral_offset_of(const SampleResult& result) const {
    const double radius = layout_.offset().depth();
    if (!result.place) return HoleFinder::kFarthestOffset * radius;
    return (*result.place - result.sample.at_depth(radius)).norm();
  }

  void apply(const SampleResult& result) {
    const bool changed = result.place && since_check_.affects(result.sample, *result.place);
    if (!changed && !result.hole && !result.too_thin) return;
    if ((changed || result.too_thin) && holes_.covered(result.sample, allowed_)) return;
    const auto place = result.place ? result.place : holes_.below(result.sample);  // throws if too thin
    if (place) close(result.sample, result.facet, *place);
  }

  /// New centres affect few stretches and leave a hole in fewer: those are gone through sample by sample.
  void recheck_all() {
    work_and_take(
        target_.stretches, [&](const Stretch& stretch) { return recheck_stretch(stretch); },
        [&](const StretchResult& result) {
          forget_before(result.centres);
          const double lateral = lateral_[result.stretch->number];
          if (result.hole || since_check_.may_affect(result.box, lateral)) close_along(*result.stretch);
        });
  }

  StretchResult recheck_stretch(const Stretch& stretch) const {
    const double radius = layout_.offset().depth();
    HoleFinder holes = holes_;
    ReachableSamples reachable(target_, radius);
    const double lateral = lateral_[stretch.number];
    NearPoints near_new = fresh_.near_parts(lateral);
    StretchResult result{&stretch, false, {}, count()};
    visit_samples(
        target_, stretch, radius,
        [&](const Corners& part) {
          for (const Eigen::Vector3d& corner : part) result.box.include(corner);
          return !result.hole && fresh_.may_affect(part, lateral, near_new);
        },
        [&](const SurfaceSample& sample, std::size_t) {
          if (!result.hole && fresh_.may_affect(sample, lateral) && reachable(sample))
            result.hole = has_hole(sample, holes);
        });
    return result;
  }

  /// Whether a sample has a hole beside a new centre, or the solid is too thin there.
  bool has_hole(const SurfaceSample& sample, HoleFinder& holes) const {
    if (holes.covered(sample, allowed_)) return false;
    try {
      const std::optional<Eigen::Vector3d> place = holes.below(sample);
      return place && fresh_.affects(sample, *place) &&
             holes.find(sample, *place, allowed_).distance >= allowed_;
    } catch (const MeshError&) {
      return true;
    }
  }

  void close_along(const Stretch& stretch) {
    const double radius = layout_.offset().depth();
    ReachableSamples reachable(target_, radius);
    visit_samples(
        target_, stretch, radius, [](const Corners&) { return true; },
        [&](const SurfaceSample& sample, std::size_t facet) {
          if (!fresh_.may_affect(sample, lateral_[stretch.number]) || !reachable(sample)) return;
          if (holes_.covered(sample, allowed_)) return;
          const std::optional<Eigen::Vector3d> place = holes_.below(sample);  // throws where it is too thin
          if (place && fresh_.affects(sample, *place))
            close(sample, static_cast<std::uint32_t>(facet), *place);
          note_new();
        });
  }

  /// Makes `since_check_` the centres from `first` on.
  void forget_before(std::size_t first) {
    if (first == since_first_) return;
    since_check_.clear();
    since_first_ = noted_ = first;
    note_new();
  }
  void note_new() {
    for (; noted_ < count(); ++noted_) {
      since_check_.insert(layout_.centres().points()[noted_]);
      if (!first_) fresh_.insert(layout_.centres().points()[noted_]);
    }
  }

  void close(const SurfaceSample& sample, std::uint32_t facet, const Eigen::Vector3d& place) {
    const Hole hole = holes_.find(sample, place, allowed_);
    if (hole.distance < allowed_) return;
    const auto added = layout_.add(hole.middle, sample.point, (1 - 1e-3) * allowed_);
    if (!added) return;
    const Corners corners = corners_of(target_.mesh, target_.facets[facet].triangles.front());
    front_.grow(*added, (corners[1] - corners[0]).normalized());
  }

  const CoverTarget& target_;
  WallLayout& layout_;
  LatticeFront front_;
  HoleFinder holes_;
  double allowed_;
  bool first_ = true;            ///< pass: all samples are checked
  NewCentres fresh_;             ///< later passes: centres of the pass before and of this one
  NewCentres since_check_;       ///< centres added since the results that are applied now were found
  std::size_t since_first_ = 0;  ///< number of the first of these
  std::size_t noted_ = 0;        ///< centres that are in both or too old for them
  SamplesKnown known_;
  std::vector<double> lateral_;  ///< m, by stretch: farthest that a place is from straight below its sample
};

}  // namespace

SamplesKnown close_cover(const CoverTarget& target, WallLayout& layout) {
  HoleCloser closer(target, layout);
  for (int pass = 0; pass < kMaxPasses && closer.pass(); ++pass) continue;
  return closer.take_known();
}

}  // namespace diefill::geometry
