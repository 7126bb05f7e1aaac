// Approximations that saved time in a run, for its results.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// A line for each economy of the scene that is off by default, and one for a preset that is unsuitable
/// for die filling. `sphere_steps`: spheres times steps of the run, those left out included.
std::vector<std::string> economies_text(const Scene& scene, const engine::Simulation& simulation,
                                        std::uint64_t sphere_steps);

}  // namespace diefill::process
