// The experiments that compare walls of spheres with the exact surface. To add one: a file here with a
// function like these, its declaration here and its line in registry.cpp.
#pragma once

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& wall_experiments();

void compare_rebound(const ExperimentOptions& options, results::ExperimentResult& result);
void compare_sliding(const ExperimentOptions& options, results::ExperimentResult& result);
void compare_beds(const ExperimentOptions& options, results::ExperimentResult& result);

}  // namespace diefill::process::laboratory
