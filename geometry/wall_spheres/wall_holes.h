// Uncovered places between wall spheres, found from points of the surface.
#pragma once

#include <array>
#include <optional>

#include "geometry/grids/near_points.h"
#include "geometry/solid/surface_samples.h"
#include "geometry/wall_spheres/wall_layout.h"

namespace diefill::geometry {

/// The emptiest place of the surface at depth R near a surface point.
struct Hole {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< m
  double distance = 0;                               ///< m, from `middle` to the nearest centre
};

/// Finds holes between the centres of a layout, which may grow meanwhile. For one thread, and fastest where
/// samples follow each other over the surface: the answer for one mostly holds for the next.
class HoleFinder {
 public:
  /// `step` is the spacing of the surface samples in m: holes are searched for that far around each.
  HoleFinder(const WallLayout& layout, double step);

  /// Whether the nearest centre is so near the sample that no hole there can be wider than `least` (m, as
  /// Hole::distance).
  bool covered(const SurfaceSample& sample, double least);
  /// The place at depth R that belongs to the sample, whatever the centres. None where the sample is so near
  /// the tip of a wedge that rounding errors prevent finding it; the empty tip is a deviation, not a hole.
  /// Throws MeshError where the solid is too thin for a sphere.
  std::optional<Eigen::Vector3d> below(const SurfaceSample& sample);
  /// The hole round `place`, the place below() the sample; distance 0 where it cannot be wider than `least`.
  /// From `place` the search goes to the point equally far from the three nearest centres, so that a hole is
  /// found in full size although samples miss its middle.
  Hole find(const SurfaceSample& sample, const Eigen::Vector3d& place, double least);
  /// Distance (m) from `place` to the nearest centre, or `limit` when none is nearer than that.
  double distance_to_nearest(const Eigen::Vector3d& place, double limit);
  /// Centres farther from a place than this (m) change nothing about the hole found there.
  double influence_radius() const { return limit() + step_; }
  /// Largest distance of below() from straight below, over R: see OffsetSurface::settle.
  static constexpr double kFarthestOffset = 1 + OffsetSurface::kFarthestMove;

 private:
  using Three = std::array<std::size_t, 3>;
  /// The path from a guess to depth R.
  struct SettlePath {
    Eigen::Vector3d guess = Eigen::Vector3d::Zero();
    OffsetSurface::Trail trail;
  };

  std::optional<Three> three_nearest(const Eigen::Vector3d& place, double radius);
  std::optional<Hole> hole_at(const Eigen::Vector3d& guess, const Eigen::Vector3d& surface_point);
  Eigen::Vector3d between_nearest(const Eigen::Vector3d& place);
  /// Distance (m) at which the search for a nearest centre ends.
  double limit() const { return 2 * layout_.spacing() + layout_.offset().depth(); }

  const WallLayout& layout_;
  double step_;
  NearPoints near_;
  /// Many samples see the same centres, between which the path is the same but for rounding.
  SpatialCache<SettlePath, 256> paths_;
};

}  // namespace diefill::geometry
