// Files that a CAD file refers to. A copy of it cannot be read without them, and describes another part if
// they differ.
#pragma once

#include <filesystem>
#include <vector>

namespace diefill::geometry {

/// What the CAD file `file` refers to, relative to its folder, each once: buffers and images of glTF and GLB,
/// material libraries of OBJ; other formats refer to nothing. Only regular files in its folder or below are
/// listed: import reports what is missing or lies elsewhere. Throws MeshError when `file` cannot be read.
std::vector<std::filesystem::path> referred_files(const std::filesystem::path& file);

}  // namespace diefill::geometry
