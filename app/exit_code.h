// Errors as an exit code and one line on standard error.
#pragma once

#include <functional>

namespace diefill::app {

/// Exit codes of the program, for scripts.
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,      ///< a full disk, a missing library: not the scene's fault
  kBadInput = 2,    ///< the scene, the CAD or the command line
  kOutOfRange = 3,  ///< the run left the method's valid range
  /// numerics.max_time was over before the scene, or that waits for what never comes: results of what there
  /// is
  kUnfinished = 4,
  kInterrupted = 130  ///< stopped by the user, can be resumed
};

/// Runs `action` and turns what it throws into one line on standard error and an exit code.
int guarded(const std::function<int()>& action);

}  // namespace diefill::app
