// Refuses scenes that runs on many ranks do not support, before any rank starts.
#pragma once

#include "process/scene/scene.h"

namespace diefill::process::cluster {

/// Throws SceneError naming the key of a scene that ranks do not support, and what to do.
void refuse_unsupported_on_ranks(const Scene& scene);

}  // namespace diefill::process::cluster
