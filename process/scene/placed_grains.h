// Grains at the places that a file gives (pour.grains_file), in place of the lattice.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "engine/powder/clump_union.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// The file; nothing for a scene that pours. Copies of a scene do not carry the grains: those who need them
/// read them.
std::optional<std::filesystem::path> grains_file_of(const Scene& scene);

/// Centre and radius of each grain. Throws SceneError when the file is not there any more, or wrong.
std::vector<engine::ClumpSphere> grains_in_file(const std::filesystem::path& file);

}  // namespace diefill::process
