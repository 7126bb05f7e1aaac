// Phases of a step that are the same for all step policies.
#pragma once

#include "engine/simulation/step_policy.h"

namespace diefill::engine {

/// Puts all tools where they are at the present time.
void move_bodies(SimulationState& state);

/// Moves all grains to the end of the step, with predicted velocities, and notes what is left of the skin.
void advance_grains(SimulationState& state, StepPolicy& policy);

/// Whether a grain or tool has moved farther than the list of near pairs allows.
bool list_is_old(const SimulationState& state);

/// Books the work of the tools from their loads of the step.
void book_wall_work(SimulationState& state);
/// Adds up what the blocks did: loads on tools, overlaps and the ledger.
void book_step(SimulationState& state);

}  // namespace diefill::engine
