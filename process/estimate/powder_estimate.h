// Powder and air as an estimate takes them.
#pragma once

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// Those of a scene, which has prepared steps.
PowderEstimate powder_estimate(const Scene& scene, const Tooling& tooling, const EstimateOptions& options);

}  // namespace diefill::process::estimate
