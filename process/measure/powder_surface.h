// How deep every grain lies below the powder surface.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// For every grain, the height in m of the highest grain centre within one grain diameter d of it, measured
/// horizontally and across periodic boundaries, above its own centre. All powder counts, inside and outside
/// the cavity, so that powder heaped or left standing over the cavity is surface enough.
std::vector<double> depth_below_surface(const results::PowderState& powder);

/// Cells closer to the surface than this many grain diameters stay out of averages.
inline constexpr double kSurfaceDepth = 2;

}  // namespace diefill::process
