// The tools as experiments see them whose walls are bodies of the engine, not CAD files.
#pragma once

#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::process::laboratory {

/// No tool in the way of the pour, and ground wherever its powder falls.
Tooling endless_ground(const Scene& scene);

}  // namespace diefill::process::laboratory
