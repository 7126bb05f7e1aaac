// The shape of a heap beyond its slope: its toe on the floor and its peak at a wall (Bierwisch 2009, section
// 3.2.3).
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct HeapShape {
  double toe;   ///< m, from the foot of the slope's line to where all but 2 % of the grains have been passed
  double peak;  ///< m, mean height that the surface lacks below that line in its highest fifth
};

/// Of the grains whose centres lie between the corners `from` and `to` (m); the floor is at from.z, the heap
/// rises along +x, or falls along it. The line is line_of_slope (process/measure/figures/heap_slope.h) of
/// columns 2 d wide. NaN for fewer than five columns.
HeapShape heap_shape(const results::PowderState& powder, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& to, bool rises);

/// d/s, mean change of height, without its sign, of the surfaces of heaps in boxes (m) from one instant to a
/// later one: of the highest grain centres in columns 2 d wide along x. Grains faster than a fall through
/// their own diameter makes them are on their way and no surface. NaN where no column has grains at both
/// instants.
double surface_drift(const results::PowderState& before, const results::PowderState& after,
                     const std::vector<Eigen::AlignedBox3d>& heaps);

}  // namespace diefill::process::laboratory
