// Groups runs into strategies: scenes that differ only in the seed are one strategy.
#pragma once

#include <string>
#include <vector>

#include "render/report/numbers.h"
#include "render/report/report.h"

namespace diefill::render::report {

/// Runs of one strategy, in the order in which they were given.
struct Strategy {
  std::string name;  ///< of its first run; its strategy as text where that distinguishes the strategies
  std::vector<const Run*> runs;

  const results::FillResult& first() const { return runs.front()->result; }
  /// A figure (results/figure_table.h) over the runs, in its stored unit.
  Scatter of(const std::string& figure_name) const;
};

/// The strategies in the order of their first runs.
std::vector<Strategy> strategies_of(const std::vector<Run>& runs);

/// The scene file's lines that say something, without comments, outer blanks and the seed.
std::vector<std::string> effective_lines(const std::string& scene_text);

/// True where the scenes differ only in title, seed and the lines that begin with `velocity`.
bool series_over_speed(const std::vector<Strategy>& strategies);

}  // namespace diefill::render::report
