// Checks lengths and positions that commands are given for finished results against the size of their powder,
// cavity and tools.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::app {

/// m, Gaussian width: `given` of --averaging-width, or where it is empty the widest that the results were
/// measured with. Throws process::SceneError for less than a tenth of the finest grains and more than the
/// largest cavity.
double averaging_width_of(const std::string& given, const std::vector<const results::FillResult*>& results);

/// m, --origin of a section through `result`: `given` has three coordinates, or none for the cavity's axis.
/// Throws process::SceneError for a point outside die, punches, cores, cavity and powder.
Eigen::Vector3d section_origin(const std::vector<std::string>& given, const results::FillResult& result);

/// m, largest edge of the box about the cavity, or about all powder where there is no cavity.
double largest_edge(const results::FillResult& result);

}  // namespace diefill::app
