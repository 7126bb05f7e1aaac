// Gathers the results of a comparison's runs and reports differences.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "process/compare/compared_measures.h"
#include "process/results/studies/comparison.h"

namespace diefill::process {

/// One more measure and how a result has it, in its unit. `value` throws SceneError where a result cannot
/// have one; the comparison then says why.
struct FurtherMeasure {
  MeasureOfComparison about;
  std::function<double(const results::FillResult&)> value;
};

/// Reads jobs.json in `directory` and the results of all jobs that are finished. Throws results::ResultError
/// where there is no list of jobs; results that cannot be read count as a failed run. Throws SceneError where
/// no finished run has a value of one of `further`.
results::Comparison collect(const std::filesystem::path& directory,
                            const std::vector<FurtherMeasure>& further = {});

/// The measures of these runs (in `runs`), variant by variant, with scatter and verdict: compared_measures(),
/// figures that belong to things of the scene, `further`.
std::vector<results::ComparedMeasure> compare_runs(const std::vector<std::string>& variants,
                                                   const std::vector<results::ComparedRun>& runs,
                                                   const std::vector<FurtherMeasure>& further = {});

}  // namespace diefill::process
