// The tools of a scene before they are covered with wall spheres: enough for cavity and motions.
#pragma once

#include "process/tooling/tooling.h"

namespace diefill::process {

/// Reads and examines the tools and resolves what the scene's steps leave to the geometry (Step::prepared),
/// as build_tooling() does, but without wall spheres. Throws SceneError or geometry::MeshError for tools that
/// cannot be used. `on_progress` receives the progress.
Tooling read_tooling(const Scene& scene, const ProgressCallback& on_progress = ignore_progress);

/// Share of the work of build_tooling() that reading takes, for a die of ten million triangles.
inline constexpr double kToolsReadShare = 0.24;

}  // namespace diefill::process
