// mpirun as a child of this program: requests to stop are passed on to it, and however it ends, one line
// reports it.
#pragma once

#include <string>
#include <vector>

namespace diefill::app {

/// Runs `words`, mpirun first, to the end, and passes on the output of the ranks. Returns the program's exit
/// code; kFailed, after one line, where mpirun or a rank ended without a message. Signals that stop the
/// program make the ranks leave a checkpoint; when this process is killed, mpirun ends its ranks. Throws
/// std::runtime_error where mpirun cannot be started.
int run_mpirun(std::vector<std::string> words);

}  // namespace diefill::app
