// The powder of a result at one of the instants that the run has kept.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::results {

/// `end`, the powder at the end, with the grains of `instant` in its place. Instants keep no angular
/// velocities: there are none.
PowderState powder_at(const PowderState& end, const Instant& instant);

}  // namespace diefill::results
