// Limits of a value, as texts of messages and as a check.
#pragma once

#include <string>
#include <string_view>

namespace diefill::process {

/// Such as "allowed: more than 0 m/s and at most 10 m/s". An empty limit is none; `above`: `least` itself is
/// not allowed.
std::string allowed_range(std::string_view least, bool above, std::string_view most);

/// Whether the value lies in the range. Tolerates the rounding of limits that are written in another unit.
bool within(double value, double least, bool above, double most);

}  // namespace diefill::process
