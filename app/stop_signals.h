// Signals that ask the program to stop: work under way then leaves a checkpoint first.
#pragma once

#include <atomic>

namespace diefill::app {

/// From now on Ctrl-C and the other signals that ask a program to stop (SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ,
/// SIGXCPU, and SIGUSR1, which mpirun passes on to ranks) set the flag that this returns. Signals that were
/// ignored at the start of the program, as with nohup, stay ignored, except SIGINT, SIGTERM and SIGUSR1.
const std::atomic<bool>& install_stop_handlers();

}  // namespace diefill::app
