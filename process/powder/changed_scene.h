// The scene as steps of kind "change" leave it: other gravity, other contact laws.
#pragma once

#include "process/machine/actions/powder_change.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// The scene with the change made. Laws of single tools that name their own parts stay as they are.
Scene changed_scene(Scene scene, const PowderChange& change);

/// The scene after each of its steps that changes laws or gravity, in their order.
std::vector<Scene> changed_scenes(const Scene& scene);

/// m/s^2, the largest magnitude of gravity at the start and after any step.
double largest_gravity(const Scene& scene);

}  // namespace diefill::process
