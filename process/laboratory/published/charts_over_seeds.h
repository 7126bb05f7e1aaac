// One chart of several seeds: their mean with the standard deviation as error bars.
#pragma once

#include <vector>

#include "process/results/studies/experiment_result.h"

namespace diefill::process::laboratory {

/// Charts of the same name as one chart; `of_seeds` has the charts of each seed. Of series with the same name
/// - points without a line are drawn for all seeds,
/// - curves become the mean over seeds at the points of the longest, with its standard deviation, where the
///   points of the others are among these,
/// - other curves are those of the first seed that has them.
/// A chart of `first_seed_only` is that of the first seed. The subtitle says which. Series without a finite
/// value are left out.
std::vector<results::ExperimentChart> charts_over_seeds(
    std::vector<std::vector<results::ExperimentChart>> of_seeds);

}  // namespace diefill::process::laboratory
