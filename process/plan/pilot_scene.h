// Which scene a pilot runs: the one that is planned, with less and coarser powder.
#pragma once

#include "process/run/tooling.h"
#include "process/scene/scene.h"

namespace diefill::process::plan {

/// The scene with as much less and coarser powder as makes it cost at most `sphere_steps`, or as little as
/// that still says something. As it stands where it costs no more.
Scene pilot_scene(const Scene& scene, const Tooling& tooling, double sphere_steps);

}  // namespace diefill::process::plan
