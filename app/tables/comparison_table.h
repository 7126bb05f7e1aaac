// A comparison as a table on the terminal.
#pragma once

#include <string>

#include "process/results/studies/comparison.h"

namespace diefill::app {

/// A block of lines for each measure, a line for each variant; then the runs that have no result, and how to
/// read the numbers.
std::string comparison_table(const results::Comparison& comparison);

}  // namespace diefill::app
