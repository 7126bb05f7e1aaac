// Statements about a run for reports: powder and model, walls, numerics, assumptions,
// versions.
#pragma once

#include <vector>

#include "process/results/fill_result.h"
#include "process/run/fill_run.h"

namespace diefill::process {

/// Version of the program, compiler, instruction set in use, libraries.
results::Topic versions_topic();

/// Statements with their units, in the order in which they are to be read. Topics "powder", "model", "walls",
/// "numerics", "assumptions" and "versions".
std::vector<results::Topic> topics(const Scene& scene, const FillRun& run);

}  // namespace diefill::process
