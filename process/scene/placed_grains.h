// Grains at the places that a file gives (pour.grains_file), in place of the lattice.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/powder/clump_union.h"

namespace diefill::process {

/// Centre and radius of each grain. Throws SceneError when the file is not there any more, or wrong.
std::vector<engine::ClumpSphere> grains_in_file(const std::filesystem::path& file);

}  // namespace diefill::process
