// Refuses scenes that cannot finish on this machine: more grains, wall spheres or stored instants than fit
// into memory, or too many time steps. Runs of days or weeks are allowed.
#pragma once

#include <string>

#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Time steps of a run at most: a month at 4,000 steps/s, which the smallest scenes reach.
inline constexpr double kMaxSteps = 1e10;
/// Spheres of grains times steps at most: months on some tens of cores.
inline constexpr double kMaxSphereSteps = 1e15;
/// Snapshots at most, each a folder of results.
inline constexpr double kMaxSnapshots = 10000;

/// Checks the scene without its tools: grains, memory, and steps as far as they do not depend on the tools.
/// Throws SceneError with the numbers and what to change.
void refuse_excessive_work(const Scene& scene);

/// Checks the whole schedule with the tools, whose steps have been prepared.
void refuse_excessive_schedule(const Scene& scene, const Tooling& tooling);

/// Throws SceneError where so many spheres of grains do not fit into the memory of this machine; `what`
/// begins the message.
void refuse_memory(const std::string& what, double spheres, double wall_spheres, double more_bytes,
                   const std::string& advice);

}  // namespace diefill::process
