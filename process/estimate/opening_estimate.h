// What an estimate says about one opening.
#pragma once

#include "process/estimate/discharge/inflow.h"
#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// What an estimate of one opening goes by.
struct EstimateInputs {
  const OpeningLayout& layout;
  const ShoePath& path;
  const InflowPowder& powder;
};

/// Opening `k` of the layout, but for what several openings share: the shoe's powder, and their names.
OpeningEstimate opening_estimate(const EstimateInputs& inputs, std::size_t k, const PowderEstimate& powder,
                                 const KnownError& error);

}  // namespace diefill::process::estimate
