// What the openings of an estimate say together.
#pragma once

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// Sets the answer, and why there is none.
void find_answer(Estimate& estimate);

}  // namespace diefill::process::estimate
