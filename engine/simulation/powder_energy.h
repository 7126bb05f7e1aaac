// The energy that the powder holds.
#pragma once

#include "engine/simulation/simulation_state.h"

namespace diefill::engine {

/// Energy of the powder now, summed in a fixed order.
Energy energy_of(const SimulationState& state);

}  // namespace diefill::engine
