// What an estimate says about a punch that falls under the shoe.
#pragma once

#include "process/estimate/opening_estimate.h"

namespace diefill::process::estimate {

/// Punch `k` of the layout. `scene` has prepared steps.
SuctionEstimate suction_estimate(const Scene& scene, const EstimateInputs& inputs, std::size_t k,
                                 const PowderEstimate& powder);

}  // namespace diefill::process::estimate
