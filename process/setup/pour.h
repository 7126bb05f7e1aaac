// The powder at the start: grains on a cubic lattice over the floor of the pour box, with small random
// offsets, random orientation and spin (Bierwisch 2009, section 4.1; sizes of the randomness assumed, OP-27).
#pragma once

#include <vector>

#include "engine/powder/new_grain.h"
#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
struct SimulationSettings;
}  // namespace diefill::engine

namespace diefill::process {

/// As many grains as the fill height needs at the expected solid fraction, stacked from the box's floor
/// upwards, higher than the box if need be; grains of several types in columns (pour_sizes.h). Deterministic
/// in the scene's seed. Throws SceneError when the box holds no grain, or a tool stands where powder is to be
/// poured and the scene does not say to pour around it. `settings`: those of the scene (material.h), with the
/// grains' shape or kinds.
std::vector<engine::NewGrain> pour(const Scene& scene, const engine::SimulationSettings& settings,
                                   const Tooling& tooling);

/// m, height of the lattice's top over the box's floor where no tool takes up room: how deep the last grain
/// falls.
double pour_height(const Scene& scene, const engine::SimulationSettings& settings);

}  // namespace diefill::process
