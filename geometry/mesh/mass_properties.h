// Volume, centre and moments of inertia of the solid that a mesh encloses.
#pragma once

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

struct MassProperties {
  double volume = 0;                                  ///< m^3
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< m^5, about the centre, over the density
};

/// Of a closed mesh with outward triangles: sums over the tetrahedra between the triangles and a point, exact
/// for the mesh.
MassProperties mass_properties(const Mesh& mesh);

}  // namespace diefill::geometry
