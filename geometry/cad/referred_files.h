// Files that a CAD file refers to. Without them a copy of it is worthless, and with others it is another
// part.
#pragma once

#include <filesystem>
#include <vector>

namespace diefill::geometry {

/// What the CAD file `file` refers to, relative to its folder, each once: buffers and images of glTF and GLB,
/// material libraries of OBJ; other kinds of file stand alone. Only regular files in its folder or below are
/// listed: what is missing or lies elsewhere, import has to complain about. Throws MeshError when `file`
/// cannot be read.
std::vector<std::filesystem::path> referred_files(const std::filesystem::path& file);

}  // namespace diefill::geometry
