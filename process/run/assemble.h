// Turns a finished run into results: measures the filled die and collects all figures of the report.
#pragma once

#include "process/results/fill_result.h"
#include "process/run/fill_run.h"

namespace diefill::process {

/// Version of the program, as results name it.
std::string program_version();

/// Everything about the finished run: powder, tools, fields and figures.
results::FillResult assemble(const Scene& scene, const Tooling& tooling, const FillRun& run);

}  // namespace diefill::process
