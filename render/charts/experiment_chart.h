// Charts of the laboratory: measurement as points, prediction as a line.
#pragma once

#include <filesystem>

#include "process/results/studies/experiment_result.h"
#include "render/charts/chart.h"

namespace diefill::render {

/// The chart as it is drawn.
Chart chart_of(const results::ExperimentChart& chart);

/// Draws the chart as `<directory>/<chart.name>.png` and returns that path. Throws what draw_chart throws.
std::filesystem::path draw_experiment(const std::filesystem::path& directory,
                                      const results::ExperimentChart& chart);

}  // namespace diefill::render
