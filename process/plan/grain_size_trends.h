// How figures move with the size of the grains, measured on small scenes with several sizes and seeds.
#pragma once

#include <vector>

namespace diefill::process::plan {

/// One figure of one scene and powder as a line over d/b, d the grain diameter, b the length that matters,
/// fitted with least squares to all runs of its table.
struct GrainSizeTrend {
  const char* scene;        ///< of sample_tools/small_dies or tradeoff; "(mesh)": with walls.kind = "mesh"
  const char* powder;       ///< name of the preset
  const char* figure;       ///< such as "mass of a full cavity"
  double slope;             ///< of the figure per d/b
  double slope_error;       ///< standard error
  double scatter;           ///< standard deviation of one run about the line
  double finest, coarsest;  ///< d/b that were run
  int runs;
};

/// Of filled cavities, b the narrowest width (grain_size_errors.csv, tests/benchmark/grain_size_errors.py
/// table). Slope and scatter are over the solid fraction that the full cavity has in the limit of small
/// grains.
const std::vector<GrainSizeTrend>& grain_size_trends();

/// Of scenes without a cavity, b the width of the opening or the depth of the powder (open_scene_errors.csv,
/// tests/benchmark/open_scene_errors.py table). Slope and scatter are over the figure in that limit.
const std::vector<GrainSizeTrend>& open_scene_trends();

}  // namespace diefill::process::plan
