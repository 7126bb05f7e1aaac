// The experiments of `diefill lab bulk_density`: how dense beds of sticky powders lie.
#pragma once

#include <vector>

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& bulk_density_experiments();

void measure_mono_disperse_beds(const ExperimentOptions& options, results::ExperimentResult& result);
void measure_log_normal_beds(const ExperimentOptions& options, results::ExperimentResult& result);

}  // namespace diefill::process::laboratory
