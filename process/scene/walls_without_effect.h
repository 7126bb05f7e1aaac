// Keys of walls that a scene gives although no contact depends on them.
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::process {

/// A line for each: a spacing of wall spheres where the mesh is the wall, a contact radius of meshes where
/// spheres are. They are not refused, since variants, --set and powder files change the kind of walls alone.
std::vector<std::string> walls_without_effect(const Scene& scene);

}  // namespace diefill::process
