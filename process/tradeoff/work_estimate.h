// The predicted cost of a setting relative to others.
#pragma once

#include "process/scene/scene.h"

namespace diefill::process {

/// m/s: fastest collision to be expected of the poured powder; tools are taken to be slower.
double expected_impact_speed(const Scene& scene);

/// The scene's time step over the critical one.
double time_step_fraction(const Scene& scene);

/// Basic spheres of the poured powder times time steps in a second of powder time. Cost goes with it between
/// settings of one scene. Throws SceneError where the scene cannot be run.
double work_per_second(const Scene& scene);

}  // namespace diefill::process
