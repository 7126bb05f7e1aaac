// The air of a cavity that powder covers as a whole.
#pragma once

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// Time that air needs to escape over the time of filling, above which it slows the filling.
inline constexpr double kAirSlows = 0.3;

/// Sets the air figures of opening `k`. Air is trapped only from when the last place of the cavity is covered
/// until the first one is free again: before and after it escapes beside the powder. None is trapped where a
/// punch fills the opening at first, nor where the cavity is longer than the shoe. `flux`: m/s, of air whose
/// drag carries the powder.
void find_trapped_air(const OpeningLayout& layout, const ShoePath& path, std::size_t k, double flux,
                      OpeningEstimate& opening);

}  // namespace diefill::process::estimate
