// Detects when a resistance no longer changes along the path of a tool, such as the torque of sheared powder.
#pragma once

#include <cstdint>

namespace diefill::process {

/// Steady: the mean over one stretch of the way differs from that over the stretch before by no more than
/// this.
struct SteadyRule {
  double within = 0;  ///< over the larger mean
  double over = 0;    ///< m or rad, length of a stretch
};

/// Means over stretches. A plain value, so that a checkpoint can store it.
struct SteadyWatch {
  double from = 0;              ///< m or rad, where the stretch under way began
  double sum = 0, lasted = 0;   ///< resistance times time, and time (s), on it
  double mean = 0;              ///< of the stretch before
  std::uint64_t stretches = 0;  ///< that are over
  std::uint64_t steady = 0;     ///< 1 once it was steady

  /// Adds the mean `resistance` over the last `interval` (s), which ended at `coordinate`.
  void add(const SteadyRule& rule, double coordinate, double resistance, double interval);
};

}  // namespace diefill::process
