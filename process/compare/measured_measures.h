// Differences from measured profiles and maps as measures of a comparison: in all, and in each zone of the
// scenes.
#pragma once

#include <string>
#include <vector>

#include "process/compare/collect.h"
#include "process/measured_data/compare_with_measured.h"

namespace diefill::process {

/// Names of the [[measure.zone]] of all job scenes in `directory`, each once. Throws results::ResultError
/// where there is no list of jobs.
std::vector<std::string> zones_of_jobs(const std::filesystem::path& directory);

/// For each file mean difference, rms difference and correlation; for each zone in which a result has
/// measured places, mean difference and correlation there.
std::vector<FurtherMeasure> measures_against(const std::vector<MeasuredFile>& files,
                                             const std::vector<std::string>& zones);

}  // namespace diefill::process
