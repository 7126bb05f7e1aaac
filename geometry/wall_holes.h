// The open places between wall spheres, seen from points of the surface.
#pragma once

#include "geometry/surface_samples.h"
#include "geometry/wall_layout.h"

namespace diefill::geometry {

/// The emptiest place of the surface at depth R near a surface point.
struct Hole {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< m
  double distance = 0;                               ///< m, from `middle` to the nearest centre
};

/// Finds holes between the centres of a layout.
class HoleFinder {
 public:
  /// `step` is the spacing of the surface samples in m: holes are looked for that far around each.
  HoleFinder(const WallLayout& layout, double step) : layout_(layout), step_(step) {}

  /// Whether the nearest centre is so near the sample that no hole there can be wider than `least` (m, as
  /// Hole::distance).
  bool covered(const SurfaceSample& sample, double least) const;
  /// The place at depth R that belongs to the sample, whatever the centres. Throws MeshError where the solid
  /// is too thin for a sphere.
  Eigen::Vector3d below(const SurfaceSample& sample) const;
  /// The hole round `place`, a place below(); distance 0 where it cannot be wider than `least`. From `place`
  /// the search goes to the point equally far from the three nearest centres, so that a hole is found in full
  /// size although samples miss its middle.
  Hole find(const Eigen::Vector3d& place, double least) const;
  /// Centres farther from a place than this (m) change nothing about the hole found there.
  double sight() const { return limit() + step_; }
  /// Farthest that below() may be from straight below, over R: see OffsetSurface::settle.
  static constexpr double kFarthestAside = 1 + OffsetSurface::kFarthestMove;

 private:
  Eigen::Vector3d between_nearest_centres(const Eigen::Vector3d& place) const;
  /// Distance (m) at which the search for a nearest centre ends.
  double limit() const { return 2 * layout_.spacing() + layout_.offset().depth(); }

  const WallLayout& layout_;
  double step_;
};

}  // namespace diefill::geometry
