// Reads the finished runs of settings: values over seeds, and costs.
#pragma once

#include "process/results/studies/job_list.h"
#include "process/results/studies/tradeoff.h"
#include "process/tradeoff/settings.h"

namespace diefill::process {

/// What stands in `directory` of `settings` with `seeds` runs each: quantities that some run has a value of,
/// one point a setting in their order, rows of parameters. The correlation of maps is with the mean map of
/// setting `reference` (its own runs with those of its other seeds); none where that is no setting. Errors
/// are not filled in.
results::Tradeoff gather(const std::filesystem::path& directory, const Scene& scene,
                         const std::vector<TriedSetting>& settings,
                         const std::vector<ParameterValues>& parameters, int seeds);

/// Adds the quantity kMapCorrelation to every point.
void add_map_correlation(results::Tradeoff& tradeoff, const std::filesystem::path& directory,
                         const std::vector<TriedSetting>& settings, int seeds, std::size_t reference);

/// The jobs of a setting, seed by seed.
std::vector<results::Job> jobs_of(const TriedSetting& setting, int seeds);

}  // namespace diefill::process
