// How figures of a filled cavity move with the size of the grains, measured on small dies with several sizes
// and seeds.
#pragma once

#include <vector>

namespace diefill::process::plan {

/// One figure of one cavity and powder as a line over d/b, d the grain diameter, b the narrowest width,
/// fitted with least squares to all runs of grain_size_errors.csv (tests/benchmark/grain_size_errors.py
/// table). Slope and scatter are over the solid fraction that the full cavity has in the limit of small
/// grains.
struct GrainSizeTrend {
  const char* cavity;       ///< of sample_tools/small_dies; "(mesh)": with walls.kind = "mesh"
  const char* powder;       ///< name of the preset
  const char* figure;       ///< "mass of a full cavity", "mean solid fraction", "unevenness"
  double slope;             ///< of the figure per d/b
  double slope_error;       ///< standard error
  double scatter;           ///< standard deviation of one run about the line
  double finest, coarsest;  ///< d/b that were run
  int runs;
};

/// All that were measured.
const std::vector<GrainSizeTrend>& grain_size_trends();

}  // namespace diefill::process::plan
