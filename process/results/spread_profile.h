// A curve with the scatter around it, and counts over a range of values.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::results {

/// Mean and scatter over the other coordinate of a map.
struct SpreadProfile {
  Profile mean;
  std::vector<double> spread;  ///< standard deviation at each x, in the mean's unit; NaN with the mean
};

/// Shares of grains by value.
struct Histogram {
  std::string quantity, unit;
  std::vector<double> middle;  ///< of each bin
  std::vector<double> share;   ///< of the grains counted, 0 to 1; sums to 1
  std::uint64_t grains = 0;
  double mean = 0, std = 0;
};

}  // namespace diefill::results
