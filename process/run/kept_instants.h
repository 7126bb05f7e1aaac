// The instants that a run has kept, as results hold them.
#pragma once

#include <vector>

#include "process/run/fill_run.h"

namespace diefill::process {

/// With the images of half models. Where the die is at its initial position now, in the laboratory frame, so
/// that films show how it was shaken; else in the frame of the die as it was then, so that they follow it.
/// `powder` is that of the results.
std::vector<results::Instant> kept_instants(const Tooling& tooling, const FillRun& run,
                                            const results::PowderState& powder);

}  // namespace diefill::process
