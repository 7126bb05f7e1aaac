// Limits of a fluid of particles: which time steps, densities and shear rates keep its temperature.
#pragma once

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

void find_fluid_limit(const ExperimentOptions& options, results::ExperimentResult& result);

}  // namespace diefill::process::laboratory
