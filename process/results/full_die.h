// From which fill ratio on a die counts as full.
#pragma once

#include <cmath>

namespace diefill::results {

/// Fill ratio from which a die counts as full: what is missing is within the error of weighing and levelling.
inline constexpr double kFullDie = 0.98;

/// True for a ratio that reads as 0.98 or more with two decimals, so that printed numbers and statements
/// agree.
inline bool is_full(double fill_ratio) {
  return std::round(100 * fill_ratio) >= std::round(100 * kFullDie);
}

}  // namespace diefill::results
