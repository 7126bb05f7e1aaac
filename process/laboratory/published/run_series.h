// A curve of a chart with one point for each run of an experiment, as far as the runs are finished.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

struct PointOfRun {
  double x;
  std::string run;
};

/// Adds a series with the points whose runs are finished; nothing where none is. `value` is called with a
/// run.
void add_run_series(results::ExperimentChart& chart, const SeedResults& seed, const std::string& name,
                    const std::vector<PointOfRun>& points,
                    const std::function<double(const std::string& run)>& value);

}  // namespace diefill::process::laboratory
