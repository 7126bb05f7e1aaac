// The experiments that look for the limits of the method. To add one: a file here with a function like these,
// its declaration here and its line in registry.cpp.
#pragma once

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

const std::vector<Experiment>& stability_experiments();

void find_time_step_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_wall_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_wall_friction_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_damping_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_cohesion_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_rotation_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_rolling_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_creep_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_attraction_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_capillary_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_size_ratio_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_piston_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_fluid_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_cavity_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_stiffness_limit(const ExperimentOptions& options, results::ExperimentResult& result);
void find_effect_of_step(const ExperimentOptions& options, results::ExperimentResult& result);
void find_effect_of_step_on_flow(const ExperimentOptions& options, results::ExperimentResult& result);

}  // namespace diefill::process::laboratory
