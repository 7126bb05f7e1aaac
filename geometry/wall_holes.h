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

  /// The hole under a surface sample; distance 0 where the nearest centre is so near that the hole cannot be
  /// wider than `least` (m, as Hole::distance). From the sample the search goes to the point equally far from
  /// the three nearest centres, so that a hole is found in full size although samples miss its middle. Throws
  /// MeshError where the solid is too thin for a sphere.
  Hole find(const SurfaceSample& sample, double least) const;

 private:
  Eigen::Vector3d below(const SurfaceSample& sample) const;
  Eigen::Vector3d between_nearest_centres(const Eigen::Vector3d& place) const;

  const WallLayout& layout_;
  double step_;
};

}  // namespace diefill::geometry
