// Scenes whose work cannot end on this machine, seen before it begins: more grains, wall spheres or kept
// instants than its memory holds, more time steps than anybody waits for. Real work of days or weeks passes.
#pragma once

#include <string>

#include "process/run/tooling.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Time steps of a run at most: a month at 4,000 steps/s, which the smallest scenes reach.
inline constexpr double kMostSteps = 1e10;
/// Spheres of grains times steps at most: months on some tens of cores.
inline constexpr double kMostSphereSteps = 1e15;
/// Snapshots at most, each a folder of results.
inline constexpr double kMostSnapshots = 10000;

/// What the scene's text alone tells: grains, memory, and steps as far as they do not depend on the tools.
/// Throws SceneError with the numbers and what to change.
void refuse_endless(const Scene& scene);

/// The same with what the tools tell, whose steps have been prepared: the whole schedule.
void refuse_endless_schedule(const Scene& scene, const Tooling& tooling);

/// Throws SceneError where so many spheres of grains do not fit into the memory of this machine; `what`
/// begins the message.
void refuse_memory(const std::string& what, double spheres, double wall_spheres, double more_bytes,
                   const std::string& advice);

}  // namespace diefill::process
