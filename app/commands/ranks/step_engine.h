// What computes the steps of runs in this program.
#pragma once

#include "process/run/step_engine.h"

namespace diefill::app {

/// Set by programs with an engine of their own before a command runs; nullptr: the built-in engine.
process::StepEngine*& step_engine();

}  // namespace diefill::app
