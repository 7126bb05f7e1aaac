// The shape of a heap beyond its slope: its toe on the floor and its peak at a wall (Bierwisch 2009, section
// 3.2.3).
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct HeapShape {
  double toe;   ///< m, from the foot of the slope's line to where all but 2 % of the grains have been passed
  double peak;  ///< m, mean height that the surface lacks below that line in its highest fifth
};

/// Of the grains whose centres lie between the corners `from` and `to` (m); the floor is at from.z, the heap
/// rises along +x, or falls along it. The line is fitted to the middle 60 % of columns 2 d wide, as that of
/// heap_slope (process/measure/figures/heap_slope.h). NaN for fewer than five columns.
HeapShape heap_shape(const results::PowderState& powder, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& to, bool rises);

}  // namespace diefill::process::laboratory
