// What does not go together with tools that nothing drives.
#pragma once

#include "process/scene/scene.h"

namespace diefill::process {

/// Throws SceneError where the scene has free tools and sleeping or carried powder, a half model or suction.
void refuse_free_tools_beside(const Scene& scene);

}  // namespace diefill::process
