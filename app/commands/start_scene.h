// Scenes to start from: one of the small sample dies with its tools, copied into a folder of the user's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::app {

/// Such as "ring", in the order in which they are offered.
std::vector<std::string> start_kinds();

/// Writes `folder`/fill.toml and the CAD files of its tools, all or nothing. Returns the scene's path. Throws
/// process::SceneError where there is such a folder or file already, std::runtime_error where the samples are
/// missing or nothing can be written.
std::filesystem::path write_start_scene(const std::filesystem::path& folder, const std::string& kind);

/// Writes `scene` as `folder`/fill.toml, which names its CAD files where they lie. Returns and throws as
/// above.
std::filesystem::path write_copied_scene(const std::filesystem::path& folder, const process::Scene& scene);

}  // namespace diefill::app
