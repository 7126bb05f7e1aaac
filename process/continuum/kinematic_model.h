// Steady flow of powder above a slit without a grain: the kinematic model and its compressible form, in a
// slice x, z. Velocities diffuse upwards from the profile in the opening.
#pragma once

#include <vector>

#include "process/continuum/diffusion_length.h"

namespace diefill::process::continuum {

/// A regular grid over a hopper from x = -width/2 to width/2 and z = 0, the opening's plane, upwards.
/// Vertical velocities and solid fractions belong to the middle of columns and to levels z = k spacing_z, row
/// k of `rows` + 1; horizontal velocities to the borders of columns.
struct HopperGrid {
  double width = 0, height = 0;  ///< m
  int columns = 0, rows = 0;

  double spacing_x() const { return width / columns; }
  double spacing_z() const { return height / rows; }
  /// m, middle of a column.
  double x(int column) const { return (column + 0.5) * spacing_x() - width / 2; }
};

/// Velocities in m/s, z up: falling powder has negative vertical ones. Row after row from the opening.
struct HopperFlow {
  HopperGrid grid;
  std::vector<double> vertical;    ///< (rows + 1) x columns
  std::vector<double> horizontal;  ///< (rows + 1) x (columns + 1), 0 on the walls
  double vertical_at(int column, int row) const { return vertical[row * grid.columns + column]; }
  double horizontal_at(int border, int row) const { return horizontal[row * (grid.columns + 1) + border]; }
};

/// Solves the steady kinematic model d/dx(B n dv_z/dx) = d/dz(n v_z), v_x = -B dv_z/dx (Bierwisch 2009,
/// Eqs. 5.7 to 5.9; with one solid fraction everywhere Eqs. 5.2 to 5.4), row by row upwards from `opening`,
/// the vertical velocities in the plane of the opening, one for each column. Conservative: every row carries
/// the same flux of powder. Second order in both spacings where the opening's profile is smooth: Crank and
/// Nicolson's rule, after four half rows of Euler's implicit one that damp what a jump at the slit's edge
/// excites. Stable for any spacing.
///
/// `fraction` has a solid fraction for each column and level, (rows + 1) x columns; empty: the same
/// everywhere. Throws std::invalid_argument where sizes do not fit or a fraction is not positive,
/// std::domain_error where B has no value.
HopperFlow solve_kinematic(const HopperGrid& grid, const std::vector<double>& opening,
                           const DiffusionLength& length, const std::vector<double>& fraction = {});

}  // namespace diefill::process::continuum
