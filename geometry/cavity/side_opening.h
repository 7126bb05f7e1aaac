// A space that would be a cavity, were it not open at the side.
#pragma once

#include <optional>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// Where powder would flow out of it.
struct SideOpening {
  double height = 0;                                ///< m, the lowest point of the way out
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, where the way out leaves the box of the solids
  double volume = 0;                                ///< m^3, of the space below the opening, to about a tenth
};

/// The opening of the largest space below height `fill_plane` (m) that `solids` (laboratory frame, closed,
/// outward) close from below and that powder would leave through their side below that plane; nothing where
/// no such space takes up a thousandth of the solids' box.
std::optional<SideOpening> find_side_opening(const std::vector<const Mesh*>& solids, double fill_plane);

}  // namespace diefill::geometry
