// Dies with several cavities: what lies in those that figures and maps are not of.
#pragma once

#include <vector>

#include "geometry/cavity.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Adds `others` (in the die's frame) to `result`, whose own cavity is number 1, with filled mass, volume and
/// solid fraction of each among the figures, and a warning that there are several. `result` holds the powder
/// and its solid fraction. Nothing for no others.
void add_other_cavities(results::FillResult& result, const std::vector<geometry::Cavity>& others);

}  // namespace diefill::process
