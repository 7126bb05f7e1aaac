// Tools as the engine has them: bodies of wall spheres or triangles.
#pragma once

#include <vector>

#include "engine/walls/walls.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// The scene's tools in their order, each in its own frame, and the mirror plane of a half model as a last
/// body.
std::vector<engine::WallBodySpec> wall_bodies(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process
