// Any value on the nodes of a plane through the powder.
#pragma once

#include <functional>

#include "process/results/fill_result.h"

namespace diefill::process {

/// A value at a point (m, laboratory frame), NaN where there is none.
using PlaneValue = std::function<double(const Eigen::Vector3d&)>;

/// `value_at` on the nodes that plane_section (measure.h) uses, NaN inside the tools' solids and in narrow
/// clearances between them. The field says "solid fraction"; callers that sample something else rename it.
results::SectionField sample_plane(const results::PowderState& powder,
                                   const results::GrainSolidFraction& fraction,
                                   const std::vector<results::ToolState>& tools,
                                   const results::SectionPlane& plane, double averaging_width,
                                   const PlaneValue& value_at);

}  // namespace diefill::process
