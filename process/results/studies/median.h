// The median of a sample.
#pragma once

#include <algorithm>
#include <vector>

namespace diefill::results {

/// The middle value, or the mean of the two in the middle. `values` is not empty.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace diefill::results
