// What ParaView shows at each instant, derived from the rest: sizes of grains, tools where they stand, and
// how much of each cell of a grid is solid.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// Cubic cells over the cavity's box.
struct ShownGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, lower corner of the first cell
  double spacing = 0;                                ///< m, edge of a cell
  std::array<std::size_t, 3> cells = {};             ///< along x, y, z; 0: no grid

  std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
};

/// One instant; the last of all is the end of the run.
struct ShownInstant {
  double time = 0;     ///< s
  std::string powder;  ///< group of /position and so on in the file, such as "/powder"
  std::size_t grains = 0;
  std::vector<double> diameter;  ///< m, of each grain
  /// m, vertices of each tool; empty where the tool stands as in /tools.
  std::vector<std::vector<Eigen::Vector3d>> vertices;
  std::vector<double> solid_share;  ///< 1, of each cell of the grid, x runs fastest
};

/// Over the cavity's box, about 1.5 of the largest diameter wide; no cells where there is no cavity.
ShownGrid shown_grid(const FillResult& result);

/// Earlier instants and the end. The solid share of a cell is the solid volume of its grains, each sphere's
/// shared among the eight nearest cells by its distance, over the cell's whole volume, tools included.
std::vector<ShownInstant> shown_instants(const FillResult& result, const ShownGrid& grid);

/// "instant", "instant_2", ...: groups of the earlier ones in /instants and /shown; then "end".
std::vector<std::string> shown_names(const FillResult& result);

}  // namespace diefill::results
