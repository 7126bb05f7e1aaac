// How much processor time this program received: on a busy machine less than it requested, and then
// wall-clock times do not measure what the work costs.
#pragma once

#include <chrono>

namespace diefill::process::plan {

/// Time of all threads of this program since they began.
struct ProcessorUse {
  double running = 0;  ///< s on a processor
  double waiting = 0;  ///< s ready to run while others had the processors

  /// Of the time between `before` and this, the share that it ran of what it wanted to; 1 where the system
  /// does not say.
  double share_since(const ProcessorUse& before) const;
};

/// As Linux books it (/proc/self/task/*/schedstat).
ProcessorUse processor_use();

/// A clock that stops while others have the processors: about what the work takes on free ones.
class FreeClock {
 public:
  FreeClock() : began_(std::chrono::steady_clock::now()), use_(processor_use()) {}
  /// s since the clock was made.
  double seconds() const;

 private:
  std::chrono::steady_clock::time_point began_;
  ProcessorUse use_;
};

}  // namespace diefill::process::plan
