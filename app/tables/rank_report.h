// What `plan --ranks` says.
#pragma once

#include "process/plan/plan.h"

namespace diefill::app {

/// Time of the scene on ranks against that on threads, what ranks exchange in a step, and from how many
/// grains on they are quicker. Says that it is unknown where there was no pilot.
void print_rank_forecast(const process::plan::Plan& plan, int threads, int ranks);

}  // namespace diefill::app
