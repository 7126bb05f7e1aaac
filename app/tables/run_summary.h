// What a run prints about the filled die.
#pragma once

#include <string>

#include "process/results/fill_result.h"

namespace diefill::app {

/// First the verdict with masses of the real powder, fill height and cycle time, one row a cavity where there
/// are several; then the mean solid fraction. Ends in a newline.
std::string filling_text(const results::FillResult& result);

}  // namespace diefill::app
