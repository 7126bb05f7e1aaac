// Instants at which an estimate looks at the tools.
#pragma once

#include <vector>

#include "process/tooling/stages.h"

namespace diefill::process::estimate {

/// s, rising, from the scene's start on: `dense` of a step, as instants(), and besides them the end of the
/// poured powder's settling, the begin of every step that moves a tool, which ends a dwell, and every
/// crossing of very many passages, which add up in a cavity though they go the same way.
std::vector<double> motion_times(const Stages& stages, const std::vector<StepState>& states, int dense);

}  // namespace diefill::process::estimate
