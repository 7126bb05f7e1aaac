// The cavity that powder is to fill: the free space below the fill plane that the standing tools enclose.
//
// Free space is searched on a voxel grid, coarsely over all tools and then finely around the result (about
// four million voxels each time); shape and widths are then measured on the tools' exact outlines in every
// layer of voxels. Radii and widths are as exact as the CAD's facets, the box to a hundredth of a voxel, the
// volume to well below 1 %. Gaps between tools up to 0.2 mm wide are fits and count as closed, from 0.5 mm on
// they count as open. A cavity must be about three coarse voxels wide, 1/50 of the cube root of the volume of
// the tools' box.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// Where a cavity is, seen from above: squares from voxel to voxel.
struct Footprint {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< m, lower corner
  double edge = 0;                                   ///< m, of a square
  Eigen::Vector2i counts = Eigen::Vector2i::Zero();
  std::vector<std::uint8_t> covered;  ///< 1 where the cavity reaches at any height; x runs fastest

  /// Whether the cavity lies above or below this place (m). False beyond the squares.
  bool covers(const Eigen::Vector2d& place) const;
};

/// Shape of a cavity. Lengths in m, laboratory frame.
struct Cavity {
  bool found = false;    ///< false for plates with slits and flat tables: nothing is enclosed from below
  bool is_ring = false;  ///< rotationally symmetric about a vertical axis, with a core
  Eigen::Vector3d axis_origin =
      Eigen::Vector3d::Zero();  ///< on the axis (no ring: in the middle of the box), at the fill plane
  double inner_radius = 0;      ///< ring only: smallest inner radius over the height
  double outer_radius = 0;      ///< ring only: largest outer radius over the height
  Box box;                      ///< around the cavity; its top is the fill plane
  double volume = 0;            ///< m^3
  double narrowest_width = 0;   ///< smallest horizontal width over the height (thickness between facing
                                ///< walls), without the tips of tapering ends (up to 2 % of the volume)
  Eigen::Vector3d narrowest_place = Eigen::Vector3d::Zero();
  Footprint footprint;
};

/// Finds the cavities below height `fill_plane` (m) between `solids` (laboratory frame, closed, outward), the
/// largest first; none below a hundredth of it. Space with a way out through the sides or below, as under a
/// slit, is none.
std::vector<Cavity> find_cavities(const std::vector<const Mesh*>& solids, double fill_plane);

/// The largest of them, or one that says that there is none.
Cavity find_cavity(const std::vector<const Mesh*>& solids, double fill_plane);

}  // namespace diefill::geometry
