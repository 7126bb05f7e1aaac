// Warnings about limits of the method that a finished run has exceeded or approached.
#pragma once

#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// A line for every limit exceeded (results/margins.h), and one where the energy lost exceeds
/// ValidityLimits::warning_energy_error; the run itself warns of energy gained.
std::vector<std::string> margin_warnings(const results::FillResult& result);

}  // namespace diefill::process
