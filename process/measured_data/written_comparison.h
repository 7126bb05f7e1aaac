// The table that a comparison with measured data leaves (measured_<file>.csv), read as measured data again.
#pragma once

#include <string>
#include <vector>

namespace diefill::process {

/// What a column of such a table is called where it is read as measured data: "fill level" of "measured fill
/// level", places and deviations by their own name, and nothing for simulated values and differences. The
/// names as they are where the table is another one.
std::vector<std::string> names_of_measurement(const std::vector<std::string>& names);

/// Whether it is such a table.
bool is_written_comparison(const std::vector<std::string>& names);

}  // namespace diefill::process
