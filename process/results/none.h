// What stands for a number that there is none of.
#pragma once

#include <limits>

namespace diefill {

/// Not a number: a value that was not found or measured.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace diefill
