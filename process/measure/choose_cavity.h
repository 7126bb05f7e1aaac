// Selects the cavity of a die with several that a result's maps and summary are of.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Makes cavity `number` the one that `result` is of: 1 is the largest, the others count from 2 as in the
/// report. Which grains lie in it and the summary of their solid fraction follow, title and strategy name it;
/// maps, profiles and figures stay those of the cavity before, to be measured again where they are wanted.
/// Throws std::invalid_argument, with the numbers there are, for any other number.
void choose_cavity(results::FillResult& result, int number);

}  // namespace diefill::process
