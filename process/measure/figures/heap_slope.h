// Slope of a heap: the angle of repose.
#pragma once

#include <Eigen/Core>
#include <string>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Slope (degrees to the horizontal, 0 to 90) of the surface of the powder whose grain centres lie between
/// the corners `from` and `to` (m). The surface is the highest grain centre in columns 2 d wide along x that
/// stands at least 2 d above `from`; the slope is that of the line fitted to the middle 60 % of these columns
/// (Bierwisch 2009, section 4.1.3; the share is assumed). NaN for fewer than three of them.
double heap_slope(const results::PowderState& powder, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Name of the figure that holds the slope of the heap of that name.
std::string heap_figure(const std::string& name);

}  // namespace diefill::process
