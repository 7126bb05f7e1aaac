// Which values a figure that was measured can have: what no run and no plant can give is a slip in a file.
#pragma once

#include <string>

#include "process/measured_data/known_fields.h"

namespace diefill::process::calibration {

/// Of the figure or quantity of the trade-off of that name, in its unit.
PossibleValues possible_values_of_figure(const std::string& name, const std::string& unit);

}  // namespace diefill::process::calibration
