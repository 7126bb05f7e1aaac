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
constexpr int kMostPasses = 6;

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

/// Centres that came into view of samples. `aside` (m) is the most that places of samples are from straight
/// below.
class Newcomers {
 public:
  Newcomers(const HoleFinder& holes, double radius)
      : sight_(holes.sight()), radius_(radius), near_(sight_), far_(kFar * sight_) {}

  void clear() {
    near_ = PointGrid(sight_);
    far_ = PointGrid(kFar * sight_);
  }
  void insert(const Eigen::Vector3d& centre) {
    near_.insert(centre);
    far_.insert(centre);
  }
  /// Whether one may change what the hole round the sample's place looks like.
  bool seen_from(const SurfaceSample& sample, const Eigen::Vector3d& place) const {
    if (near_.points().empty()) return false;
    return near_.any_within(place, sight_ + (sample.at_depth(radius_) - place).norm());
  }
  /// The same, in doubt true, before the place is known.
  bool may_be_seen_from(const SurfaceSample& sample, double aside) const {
    return !near_.points().empty() && grid(aside).any_within(sample.at_depth(radius_), sight(aside));
  }
  /// The same for samples anywhere in a box.
  bool may_be_seen_from(const Box& box, double aside) const {
    const double farthest = sight(aside) + radius_;
    return std::any_of(near_.points().begin(), near_.points().end(), [&](const Eigen::Vector3d& centre) {
      const Eigen::Vector3d beyond = (box.lower - centre).cwiseMax(centre - box.upper).cwiseMax(0);
      return beyond.squaredNorm() <= farthest * farthest;
    });
  }
  /// The same for samples of a part, asked of near_parts().
  bool may_be_seen_from(const Corners& part, double aside, NearPoints& near_parts) const {
    if (near_.points().empty()) return false;
    const Eigen::Vector3d middle = (part[0] + part[1] + part[2]) / 3;
    double farthest = 0;
    for (const Eigen::Vector3d& corner : part) farthest = std::max(farthest, (corner - middle).norm());
    return near_parts.any_within(middle, farthest + radius_ + sight(aside));
  }
  NearPoints near_parts(double aside) const {
    return {far_, kPartLength * radius_ + sight(aside), kPartLength * radius_};
  }

 private:
  static constexpr double kFar = 6, kRounding = 1e-9;
  /// A centre sees a place from `sight_` and as much more as that is aside.
  double sight(double aside) const { return (sight_ + 2 * aside) * (1 + kRounding); }
  const PointGrid& grid(double aside) const { return 2 * aside < sight_ ? near_ : far_; }

  double sight_, radius_;  // m
  PointGrid near_, far_;   ///< the same centres in small and in large cells
};

/// Fills holes with centres, sample by sample. New centres may bring a hole into a sample's view that it did
/// not see before, so that further passes are due; they look again only where a centre came into view. All
/// cores look for holes, in turns with filling those found: what was seen stands until a centre comes into
/// view, so that the outcome is that of looking at one sample after the other.
class HoleCloser {
 public:
  HoleCloser(const CoverTarget& target, WallLayout& layout)
      : target_(target),
        layout_(layout),
        front_(layout),
        holes_(layout, kSampleStep * layout.offset().depth()),
        allowed_(cover_distance(layout.spacing())),
        fresh_(holes_, layout.offset().depth()),
        since_look_(fresh_),
        known_(target.stretches.size()),
        aside_(target.stretches.size(), 0) {}

  /// True when centres were added.
  bool pass() {
    const std::size_t before = count();
    if (first_)
      look_at_all();
    else
      look_again();
    fresh_.clear();
    for (std::size_t i = before; i < count(); ++i) fresh_.insert(layout_.centres().points()[i]);
    first_ = false;
    return count() > before;
  }

  SamplesKnown take_known() { return std::move(known_); }

 private:
  /// A look at a sample that no centre covers.
  struct Look {
    SurfaceSample sample;
    std::uint32_t facet = 0;
    std::optional<Eigen::Vector3d> place;  ///< at depth R; none where it was not looked for or is none
    bool too_thin = false;                 ///< none: a fault only if the sample is not covered in the end
    bool hole = false;                     ///< there was one
    std::size_t centres = 0;               ///< there were
  };

  /// Whether samples of a stretch may see a hole that they did not see before.
  struct Again {
    const Stretch* stretch = nullptr;
    bool hole = false;        ///< one does, or sees that the solid is too thin
    Box box;                  ///< round its parts near powder, m
    std::size_t centres = 0;  ///< there were
  };

  std::size_t count() const { return layout_.centres().points().size(); }

  void look_at_all() {
    StretchProgress progress(target_, kHolesBegin, kLaterLooksBegin);
    work_and_take(
        target_.stretches, [&](const Stretch& stretch) { return look_at(stretch); },
        [&](const std::vector<Look>& looks) {
          progress.next();
          for (const Look& look : looks) {
            forget_before(look.centres);
            take(look);
            note_new();
          }
        });
  }

  /// Each stretch is looked at by one thread at a time, which alone writes what is known of it.
  std::vector<Look> look_at(const Stretch& stretch) {
    const double radius = layout_.offset().depth();
    HoleFinder holes = holes_;
    std::vector<Look> looks;
    sample_stretch(target_, stretch, radius, known_[stretch.number],
                   [&](const SurfaceSample& sample, std::size_t facet, SampleKnown& known_here) {
                     if (holes.covered(sample, allowed_)) {
                       known_here = SampleKnown::kCovered;
                       return;
                     }
                     looks.push_back({sample, static_cast<std::uint32_t>(facet), {}, false, false, count()});
                     look(looks.back(), holes);
                     const double aside = aside_of(looks.back());
                     if (aside == 0) known_here = SampleKnown::kStraightBelow;
                     aside_[stretch.number] = std::max(aside_[stretch.number], aside);
                   });
    return looks;
  }

  void look(Look& look, HoleFinder& holes) const {
    try {
      look.place = holes.below(look.sample);
      look.hole = holes.find(look.sample, *look.place, allowed_).distance >= allowed_;
    } catch (const MeshError&) {
      look.too_thin = true;
    }
  }

  /// m, how far the sample's place is from straight below.
  double aside_of(const Look& look) const {
    const double radius = layout_.offset().depth();
    if (!look.place) return HoleFinder::kFarthestAside * radius;
    return (*look.place - look.sample.at_depth(radius)).norm();
  }

  void take(const Look& look) {
    const bool changed = look.place && since_look_.seen_from(look.sample, *look.place);
    if (!changed && !look.hole && !look.too_thin) return;
    if ((changed || look.too_thin) && holes_.covered(look.sample, allowed_)) return;
    close(look.sample, look.facet,
          look.place ? *look.place : holes_.below(look.sample));  // throws if too thin
  }

  /// Few stretches see a centre that came, and fewer a hole: those are gone through sample by sample.
  void look_again() {
    work_and_take(
        target_.stretches, [&](const Stretch& stretch) { return look_again_at(stretch); },
        [&](const Again& again) {
          forget_before(again.centres);
          const double aside = aside_[again.stretch->number];
          if (again.hole || since_look_.may_be_seen_from(again.box, aside)) close_along(*again.stretch);
        });
  }

  Again look_again_at(const Stretch& stretch) const {
    const double radius = layout_.offset().depth();
    HoleFinder holes = holes_;
    ReachableSamples reachable(target_, radius);
    const double aside = aside_[stretch.number];
    NearPoints newcomers = fresh_.near_parts(aside);
    Again again{&stretch, false, {}, count()};
    visit_samples(
        target_, stretch, radius,
        [&](const Corners& part) {
          for (const Eigen::Vector3d& corner : part) again.box.include(corner);
          return !again.hole && fresh_.may_be_seen_from(part, aside, newcomers);
        },
        [&](const SurfaceSample& sample, std::size_t) {
          if (!again.hole && fresh_.may_be_seen_from(sample, aside) && reachable(sample))
            again.hole = sees_hole(sample, holes);
        });
    return again;
  }

  /// Whether a sample sees a hole beside a new centre, or that the solid is too thin.
  bool sees_hole(const SurfaceSample& sample, HoleFinder& holes) const {
    if (holes.covered(sample, allowed_)) return false;
    try {
      const Eigen::Vector3d place = holes.below(sample);
      return fresh_.seen_from(sample, place) && holes.find(sample, place, allowed_).distance >= allowed_;
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
          if (!fresh_.may_be_seen_from(sample, aside_[stretch.number]) || !reachable(sample)) return;
          if (holes_.covered(sample, allowed_)) return;
          const Eigen::Vector3d place = holes_.below(sample);  // throws where it is too thin
          if (fresh_.seen_from(sample, place)) close(sample, static_cast<std::uint32_t>(facet), place);
          note_new();
        });
  }

  /// Makes the centres since the last look those from `first` on.
  void forget_before(std::size_t first) {
    if (first == since_first_) return;
    since_look_.clear();
    since_first_ = noted_ = first;
    note_new();
  }
  void note_new() {
    for (; noted_ < count(); ++noted_) {
      since_look_.insert(layout_.centres().points()[noted_]);
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
  bool first_ = true;            ///< pass: all samples are looked at
  Newcomers fresh_;              ///< later passes: centres of the pass before and of this one
  Newcomers since_look_;         ///< centres that came since the looks that are taken now
  std::size_t since_first_ = 0;  ///< number of the first of these
  std::size_t noted_ = 0;        ///< centres that are in both or too old for them
  SamplesKnown known_;
  std::vector<double> aside_;  ///< m, by stretch: farthest that a place is from straight below its sample
};

}  // namespace

SamplesKnown close_cover(const CoverTarget& target, WallLayout& layout) {
  HoleCloser closer(target, layout);
  for (int pass = 0; pass < kMostPasses && closer.pass(); ++pass) continue;
  return closer.take_known();
}

}  // namespace diefill::geometry
