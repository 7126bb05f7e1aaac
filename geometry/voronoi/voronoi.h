// Voronoi cells of grains made of spheres (voro++), cut at walls on the wall spheres' surface
// (Bierwisch 2009, section 2.6).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// What to divide. Lengths in m. Between spheres of unequal radii the dividing plane is the radical plane,
/// from which tangents to both are equally long, so it never cuts a sphere that the other does not touch;
/// between equal ones it is halfway. A sphere's cell is cut at every wall sphere by the plane that touches
/// the wall sphere where it is nearest to the sphere's centre; the volume of walls belongs to no cell.
struct VoronoiRequest {
  std::vector<Eigen::Vector3d> sphere_centres;  ///< grain after grain
  std::size_t spheres_per_grain = 1;
  /// Place of each sphere's grain, rising, where grains have different numbers of spheres; otherwise empty.
  std::vector<std::uint32_t> grains_of_spheres;
  double sphere_radius = 0;          ///< of all spheres
  std::vector<double> sphere_radii;  ///< one per sphere, in place of sphere_radius; empty: all are equal
  std::vector<Eigen::Vector3d> wall_centres;    ///< wall spheres; they have no cells
  std::vector<double> wall_radii;               ///< one a wall sphere
  std::array<std::optional<double>, 3> period;  ///< box centred on the origin
  double largest_reach = 0;  ///< m, no part of a cell is farther than this from its sphere's centre
};

/// Cells of grains: the union of the cells of a grain's spheres.
struct VoronoiCells {
  std::vector<double> volume;  ///< m^3, one per grain
  std::vector<std::uint8_t>
      open;  ///< 1 where the limit of reach cut the cell, or none was found: no meaningful volume
};

/// Divides space between the grains. The same bits for the same request, whatever the number of threads.
/// Throws std::invalid_argument for radii, reach or periods that are not positive and for arrays that do not
/// match.
VoronoiCells voronoi_cells(const VoronoiRequest& request);

}  // namespace diefill::geometry
