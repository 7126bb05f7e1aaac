// Turns a finished run into results: measures the filled die and collects all figures of the report.
#pragma once

#include "process/results/fill_result.h"
#include "process/run/fill_run.h"

namespace diefill::process {

/// Version of the program, as results name it.
std::string program_version();

/// Powder, tools and cavity as they are now, without fields and figures; of a run under way too.
results::FillResult powder_and_tools(const Scene& scene, const Tooling& tooling, const FillRun& run);

/// The figures from which results::margins determines how far the run is from the limits of the method.
void add_margin_figures(results::FillResult& result, const FillRun& run);

/// Everything about the finished run: powder, tools, fields and figures.
results::FillResult assemble(const Scene& scene, const Tooling& tooling, const FillRun& run);

}  // namespace diefill::process
