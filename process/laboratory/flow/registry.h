// The experiments of `diefill lab flow`: flowing powder against continuum models.
#pragma once

#include <vector>

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& flow_experiments();

void compare_hopper(const ExperimentOptions& options, results::ExperimentResult& result);
void measure_transient(const ExperimentOptions& options, results::ExperimentResult& result);

}  // namespace diefill::process::laboratory
