// The density of the cavity in the cells of a regular grid.
#pragma once

#include <string>
#include <vector>

#include "process/measure/fields/element_density.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Cubic cells over the cavity's box; x runs fastest.
struct DensityGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, lower corner of the first cell
  double spacing = 0;                                ///< m, edge of a cell
  Eigen::Vector3i cells = Eigen::Vector3i::Ones();
  std::vector<double> mass;      ///< kg, of the cavity's grains in the cell
  std::vector<double> relative;  ///< 1, averaged field at the cell's middle; NaN outside powder and in tools
  double solid_density = 0;      ///< kg/m^3, that it is relative to

  Eigen::Vector3d middle(int x, int y, int z) const {
    return origin + spacing * (Eigen::Vector3d(x, y, z) + Eigen::Vector3d::Constant(0.5));
  }
};

/// The cells are symmetric about the middle of the cavity's box, so that no middle of a cell lies on its
/// walls; a whole number of them fits where the box is a multiple of `spacing` (m). Masses: solid volume of
/// the spheres in each cell (exact, cartesian_volumes) of the grains in the cavity, with a margin so that
/// none reaches beyond the grid; they sum to that of the request. Relative density: the averaged field at a
/// point, scaled as the request's mass is to that of the grains. Throws std::invalid_argument for a cavity
/// that is not known, and more than 20 million cells.
DensityGrid density_grid(const results::FillResult& result, double spacing, const DensityRequest& request);

/// A row per cell that holds mass or has a density: x, y, z (m, middle), mass, relative density, density.
std::string density_grid_csv(const DensityGrid& grid);

}  // namespace diefill::process
