// N threads on one bed compared with N programs of one thread each: what threads lose to serial parts,
// waiting and shared memory.
#pragma once

#include <string>
#include <vector>

namespace diefill::app {

/// A measurement of this program to be repeated.
struct CopiesBenchmark {
  std::vector<std::string> words;  ///< of `diefill bench`, without threads
  int threads = 2;
  int repeats = 5;
  bool json = false;
};

/// Runs threads and copies in turns, each pinned to the same processors, and prints every measurement, the
/// medians, and what the counts predict for more processors. Throws SceneError where this machine has fewer
/// processors than threads, std::runtime_error where a measurement fails.
int compare_with_copies(const CopiesBenchmark& benchmark);

}  // namespace diefill::app
