// Charts of the laboratory: measurement as points, prediction as a line.
#pragma once

#include <filesystem>

#include "process/results/experiment_result.h"

namespace diefill::render {

/// Draws the chart as `<directory>/<chart.name>.png` and returns that path. Throws what draw_chart throws.
std::filesystem::path draw_experiment(const std::filesystem::path& directory,
                                      const results::ExperimentChart& chart);

}  // namespace diefill::render
