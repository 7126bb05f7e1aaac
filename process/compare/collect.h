// Gathers the results of a comparison's runs and reports differences.
#pragma once

#include <filesystem>

#include "process/results/comparison.h"

namespace diefill::process {

/// Reads jobs.json in `directory` and the results of all jobs that are finished. Throws results::ResultError
/// where there is no list of jobs; results that cannot be read count as a failed run.
results::Comparison collect(const std::filesystem::path& directory);

/// The measures of these runs (in `runs`), variant by variant, with scatter and verdict.
std::vector<results::ComparedMeasure> compare_runs(const std::vector<std::string>& variants,
                                                   const std::vector<results::ComparedRun>& runs);

}  // namespace diefill::process
