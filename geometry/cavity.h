// The cavity that powder is to fill: the free space below the fill plane that the standing tools enclose.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace diefill::geometry {

/// Shape of a cavity. Lengths in m, laboratory frame.
struct Cavity {
  bool found = false;         ///< false for plates with slits and flat tables: nothing is enclosed from below
  bool is_ring = false;       ///< rotationally symmetric about a vertical axis, with a core (within half a voxel)
  Eigen::Vector3d axis_origin = Eigen::Vector3d::Zero();  ///< on the axis, at the fill plane
  double inner_radius = 0;    ///< ring only: smallest inner radius over the height
  double outer_radius = 0;    ///< ring only: largest outer radius over the height
  Box box;                    ///< around the cavity; its top is the fill plane
  double volume = 0;          ///< m^3
  double narrowest_width = 0; ///< smallest horizontal width over the height (thickness between facing walls)
  Eigen::Vector3d narrowest_place = Eigen::Vector3d::Zero();
};

/// Finds the cavity below height `fill_plane` (m) between `solids` (laboratory frame, closed, outward).
Cavity find_cavity(const std::vector<const Mesh*>& solids, double fill_plane);

}  // namespace diefill::geometry
