// The program from its command line to its exit code.
#pragma once

namespace diefill::app {

/// Runs the command that the words name; returns the exit code.
int run_program(int argc, char** argv);

}  // namespace diefill::app
