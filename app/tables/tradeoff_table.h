// Settings with their costs and errors as a table on the terminal.
#pragma once

#include <string>

#include "process/results/studies/tradeoff.h"

namespace diefill::app {

/// A line for each setting, cheapest first; then advice and remarks.
std::string tradeoff_table(const results::Tradeoff& tradeoff);

}  // namespace diefill::app
