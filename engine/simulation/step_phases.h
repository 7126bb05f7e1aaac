// Phases of a step that are the same for all step policies.
#pragma once

#include "engine/simulation/step_policy.h"

namespace diefill::engine {

/// Puts all tools where they are at the present time.
void move_bodies(SimulationState& state);

/// Moves all grains to the end of the step, with predicted velocities, and notes what is left of the skin.
void advance_grains(SimulationState& state, StepPolicy& policy);

/// Whether a grain or tool has moved farther than the neighbour list allows.
bool list_is_old(const SimulationState& state);

/// Adds the work of the tools in this step, from their loads, to the ledger.
void add_wall_work(SimulationState& state);
/// Adds up what the blocks did: loads on tools, overlaps and the ledger.
void add_up_blocks(SimulationState& state);

}  // namespace diefill::engine
