// How long the machine is at work, in a run or a predicted one.
#pragma once

#include <vector>

#include "process/tooling/stages.h"

namespace diefill::process {

/// s during which any step is on that moves a tool or lasts a given time; steps that have not ended do not
/// count. Waiting for the powder to rest is not counted: a press does not wait for it.
double busy_time(const Stages& stages, const std::vector<StepState>& states);

}  // namespace diefill::process
