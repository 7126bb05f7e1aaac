// Grains that are given one by one, by a file or by another run, in a half model (economy.mirror).
#pragma once

#include <string>
#include <vector>

#include "engine/powder/new_grain.h"
#include "engine/simulation/settings.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Those of `grains` whose centre lies in front of the mirror plane: the others are shown as images. All of
/// them where the scene is no half model. `key`: of [pour], which gives them. Throws SceneError for a grain
/// that reaches through the plane, where it would start inside its own image.
std::vector<engine::NewGrain> near_half(const Scene& scene, const engine::SimulationSettings& settings,
                                        std::vector<engine::NewGrain> grains, const std::string& key);

}  // namespace diefill::process
