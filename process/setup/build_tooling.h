// From the tools of a scene to bodies for the engine: read, examined, and covered with wall spheres.
#pragma once

#include "process/tooling/tooling.h"

namespace diefill::process {

/// Reads and examines the tools, settles what the scene's steps leave to the geometry (Tooling::steps), and
/// covers what powder can reach with wall spheres. `smallest_radius` (m) is that of the powder's spheres: a
/// wall it could pass is refused. `on_progress` receives the progress, which takes long for tools of millions
/// of triangles. Throws SceneError or geometry::MeshError for tools that cannot be used.
Tooling build_tooling(const Scene& scene, double smallest_radius, double grain_diameter,
                      const ProgressCallback& on_progress = ignore_progress);

}  // namespace diefill::process
