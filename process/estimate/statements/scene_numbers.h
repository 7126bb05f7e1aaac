// Numbers without unit that order scenes: Bond, Froude, the Pi numbers of the contact law, air.
#pragma once

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// Those of a scene's powder; with the shoe's speed where one moves. Cohesion and Pi numbers belong to
/// Bierwisch's contact law: they are left out where [contact] says another.
std::vector<SceneNumber> scene_numbers(const Scene& scene, const Estimate& estimate);

}  // namespace diefill::process::estimate
