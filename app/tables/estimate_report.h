// What `diefill estimate` prints, and the short form at the head of `plan` and `check`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "process/estimate/estimate.h"

namespace diefill::app {

/// "fills", "too fast", "open" or "nothing to fill".
const char* name_of(process::estimate::Answer answer);
/// All statements, each with source, range and error, and the numbers.
void print_estimate(const process::estimate::Estimate& estimate);
/// SI units.
nlohmann::ordered_json estimate_as_json(const process::estimate::Estimate& estimate);

/// The answer alone, for commands that begin with it.
void print_estimate_in_short(const process::estimate::Estimate& estimate);

}  // namespace diefill::app
