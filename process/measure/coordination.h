// Contacts of every grain, found from positions alone.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Number of other grains that every grain touches: at least one of its spheres overlaps one of theirs,
/// within `tolerance` (of the sphere radius), across periodic boundaries too. Several contacts of the same
/// two grains count once; walls do not count, nor does a grain's own image.
std::vector<int> coordination_numbers(const results::PowderState& powder, double tolerance = 1e-9);

}  // namespace diefill::process
