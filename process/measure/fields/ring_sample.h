// Any value on the nodes of an unrolled ring.
#pragma once

#include "process/measure/fields/plane_sample.h"

namespace diefill::process {

/// `value_at`, mean over the radius weighted by radius where it is finite and outside the tools' solids, on
/// the nodes that cylindrical_map (measure.h) uses. The field says "solid fraction"; callers that sample
/// something else rename it. Throws std::invalid_argument for cavities that are no rings.
results::Field2D sample_ring(const results::PowderState& powder, const std::vector<results::ToolState>& tools,
                             const results::CavityState& cavity, double averaging_width,
                             const PlaneValue& value_at);

}  // namespace diefill::process
