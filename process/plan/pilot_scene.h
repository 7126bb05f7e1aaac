// Which scene a pilot runs: the one that is planned, with less and coarser powder.
#pragma once

#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::process::plan {

/// The scene with less and coarser powder, so that it costs at most `sphere_steps`, down to the least that is
/// still representative. Unchanged where it costs no more.
Scene pilot_scene(const Scene& scene, const Tooling& tooling, double sphere_steps);

}  // namespace diefill::process::plan
