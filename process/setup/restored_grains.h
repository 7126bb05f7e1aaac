// Grains as another run left them: places, orientations and velocities. Springs of contacts start again, so
// that the powder moves by some overlaps until it carries itself again.
#pragma once

#include <vector>

#include "engine/powder/new_grain.h"
#include "process/scene/saved_state.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
struct SimulationSettings;
}  // namespace diefill::engine

namespace diefill::process {

/// Grains of `state` for a scene with the same powder. Throws SceneError where its grains differ from those
/// of the scene in kind or size, none is left below the cut, the periods differ, or a grain is in a tool.
std::vector<engine::NewGrain> restored_grains(const Scene& scene, const engine::SimulationSettings& settings,
                                              const Tooling& tooling, const SavedState& state);

}  // namespace diefill::process
