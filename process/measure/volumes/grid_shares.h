// How one sphere's volume is divided among the cells of a grid; the core of partial volumes.
#pragma once

#include "process/results/cell_field.h"

namespace diefill::process {

/// Range of cells along one coordinate.
struct CellRange {
  std::size_t first = 0, last = 0;  ///< both included
  bool empty = true;
};

/// Cells that the interval lower..upper reaches into, of those between `edges`.
CellRange cells_between(const std::vector<double>& edges, double lower, double upper);

/// Adds `weight` times the sphere's volume, in parts, to the cells of a Cartesian field.
void share_sphere(results::CellField& field, const std::array<double, 3>& centre, double radius,
                  double weight);

/// The same for a cylindrical field (edges of azimuth in rad): the centre's distance from the axis, azimuth
/// (rad) and height.
void share_sphere_round(results::CellField& field, double distance, double azimuth, double height,
                        double radius, double weight);

}  // namespace diefill::process
