// What the interactive view shows of one run besides its result: the density field on a grid, and solid
// fractions at earlier instants. Measured elsewhere; the view draws.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::render::report {

/// Averaged solid fraction on the points of a Cartesian grid; NaN: no powder there.
struct DensityGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, first point, laboratory frame
  double spacing = 0;                                ///< m, along all three axes
  Eigen::Vector3i counts = Eigen::Vector3i::Zero();  ///< points along x, y, z
  std::vector<double> value;                         ///< x runs fastest
  double averaging_width = 0;                        ///< m, sigma of (Bierwisch 2009, Eq. 2.27)
};

/// Solid fractions of the grains of one kept instant, in its order; NaN: open cell.
struct InstantFractions {
  std::size_t instant = 0;  ///< place in FillResult::instants
  std::vector<double> solid_fraction;
};

/// Extras of the view. Both may be empty: the view then offers less.
struct ViewExtras {
  DensityGrid density;
  std::vector<InstantFractions> fractions;
};

/// A run as the view takes it.
struct ViewedRun {
  std::string name;
  const results::FillResult* result = nullptr;
  const ViewExtras* extras = nullptr;  ///< nullptr: none
};

/// Places of at most `most` kept instants, evenly spread, the first among them.
std::vector<std::size_t> spread_instants(std::size_t instants, std::size_t most);

}  // namespace diefill::render::report
