// Signals that ask the program to stop: work under way then leaves a checkpoint first; a set-up, which has
// written nothing yet, ends at once.
#pragma once

#include <array>
#include <atomic>
#include <csignal>

namespace diefill::app {

/// From now on Ctrl-C and the other signals that ask a program to stop (SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ,
/// SIGXCPU, and SIGUSR1, which mpirun passes on to ranks) set the flag that this returns. Signals that were
/// ignored at the start of the program, as with nohup, stay ignored, except SIGINT, SIGTERM and SIGUSR1.
const std::atomic<bool>& install_stop_handlers();

/// While it lives, Ctrl-C, SIGTERM and (unless it was ignored) SIGHUP end the program at once, with one line
/// on standard error and the exit code of a stopped run; nothing where the program has handlers of its own by
/// then. For work that reads and prepares but has written nothing. A child that reads CAD ends with its
/// parent (geometry/cad/cad_child).
class StopDuringSetUp {
 public:
  StopDuringSetUp();
  ~StopDuringSetUp();
  StopDuringSetUp(const StopDuringSetUp&) = delete;
  StopDuringSetUp& operator=(const StopDuringSetUp&) = delete;

 private:
  static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<bool, kSignals.size()> taken_{};
  std::array<struct sigaction, kSignals.size()> before_{};
};

/// What is said where a set-up is stopped.
inline constexpr const char* kStoppedDuringSetUp = "stopped during set-up: nothing was written";

}  // namespace diefill::app
