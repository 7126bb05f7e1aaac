// Clumps of the user's own: mass, centre and moments of inertia of the union of overlapping spheres of any
// radii, where every point of the material counts once.
#pragma once

#include <vector>

#include "engine/powder/grain_shape.h"

namespace diefill::engine {

/// A sphere of a clump, in any frame.
struct ClumpSphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m
  double radius = 0;                                 ///< m
};

/// The rigid grain that the union of `spheres` makes of a material of `density` (kg/m^3): offsets are moved
/// to the centre of mass and turned into the principal frame. Volumes are integrated exactly along lines of a
/// grid across them: to better than 1e-4. Throws std::invalid_argument for no spheres, and for radii or a
/// density that are not positive.
GrainShape grain_of_union(const std::vector<ClumpSphere>& spheres, double density);

}  // namespace diefill::engine
