// Slope of a heap: the angle of repose.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "process/measure/figures/line_fit.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Slope (degrees to the horizontal, 0 to 90) of the surface of the powder whose grain centres lie between
/// the corners `from` and `to` (m): that of line_of_slope, the surface being the highest grain centre in
/// columns 2 d wide along x. NaN where there is no such line.
double heap_slope(const results::PowderState& powder, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Points (x, z) of a heap's surface in the order of x, m.
using HeapSurface = std::vector<std::pair<double, double>>;

/// The line of least squares through the middle 60 % of a heap's height above `floor` (m), from `least` (m)
/// above it on (Bierwisch 2009, section 4.1.3; the share is assumed): points of the surface, and where the
/// surface crosses both ends. Toe and flat top are no part of it. NaN for fewer than three points.
FittedLine line_of_slope(HeapSurface surface, double floor, double least);

/// Name of the figure that holds the slope of the heap of that name.
std::string heap_figure(const std::string& name);

}  // namespace diefill::process
