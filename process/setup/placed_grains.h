// Grains at the places that a file gives, such as a packing that was made before or that others published.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/powder/new_grain.h"
#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
struct SimulationSettings;
}  // namespace diefill::engine

namespace diefill::process {

/// Grains of `file` (pour.grains_file) at rest, each of the type whose radius it has within a hundredth.
/// Throws SceneError for clumps, for a radius that no powder of the scene has, and for a grain that starts in
/// a tool.
std::vector<engine::NewGrain> placed_grains(const Scene& scene, const engine::SimulationSettings& settings,
                                            const Tooling& tooling, const std::filesystem::path& file);

}  // namespace diefill::process
