// How fast things may hit each other in a scene: sets the critical time step.
#pragma once

#include "process/tooling/tooling.h"

namespace diefill::process {

/// m/s: fastest collision to be expected of grains that fall by `fall_height`, in m, or are given random
/// velocities by steps of the scene.
double expected_impact_speed(const Scene& scene, double fall_height);

/// m/s: fastest collision to be expected in a scene, from the depth of the pour, of the cavity, and the
/// tools' motion. Steps must have been prepared.
double predicted_impact_speed(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process
