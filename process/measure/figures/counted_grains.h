// Which grains enter averages: those with meaningful cells, deep enough below the surface.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Numbers of the grains with a closed cell at least kSurfaceDepth d below the powder surface, in rising
/// order; only those in the cavity if `only_cavity`.
std::vector<std::size_t> counted_grains(const results::PowderState& powder,
                                        const results::GrainSolidFraction& fraction, bool only_cavity);

}  // namespace diefill::process
