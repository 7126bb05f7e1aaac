// Minimum number of grains behind a figure.
#pragma once

#include <cstddef>
#include <string>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Fewest grains behind a mean, a standard deviation, or each coefficient or part of a figure that compares
/// several. The mean of n grains is off by about their spread over sqrt(n), the spread by 1 / sqrt(2 n - 2)
/// of itself: at 20 grains 22 % of the spread and 16 %. With fewer, figures describe single grains.
inline constexpr std::size_t kMinGrains = 20;

/// "only 8 grains lie two diameters below the surface in the cavity; 20 are needed".
std::string too_few_text(std::size_t grains, const std::string& where, std::size_t needed);

/// Takes away the figures of the result's cavity, its summary included, that stand on too few grains, and
/// says why in the topic "no value" (results/no_value.h). Grains that lie all in one part of the cavity leave
/// harmonics undetermined: amplitudes beyond the mean are taken away as well.
void withhold_poor_figures(results::FillResult& result);

/// Copies of a summary without the numbers that too few grains stand behind.
results::SolidFractionSummary reliable_summary(results::SolidFractionSummary summary);

}  // namespace diefill::process
