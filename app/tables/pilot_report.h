// What a pilot run has found: where the wall times of a plan come from.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "process/plan/pilot.h"

namespace diefill::app {

/// Lines on the terminal: the pilot's size, its costs by kind of phase, and how they depend on size.
void print_pilot(const process::plan::Pilot& pilot);

/// The same in SI units.
nlohmann::ordered_json pilot_as_json(const process::plan::Pilot& pilot);

/// Whether the pilot got so little processor time that the report says so.
bool is_busy(const process::plan::Pilot& pilot);

}  // namespace diefill::app
