// A calibration on the terminal: the powder with its intervals, what the data cannot determine, measured
// against simulated.
#pragma once

#include <string>

#include "process/results/studies/calibration.h"

namespace diefill::app {

/// Lines, the last with its line end.
std::string calibration_table(const results::Calibration& calibration);

}  // namespace diefill::app
