// The bytes of a CAD file, and the checks of them that come before any importer sees them.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::geometry {

/// All bytes of `file`. Throws MeshError when it is missing, a directory, not readable or empty.
std::string read_cad_file(const std::filesystem::path& file);

/// Throws MeshError when `bytes` of an STL file are fewer than its header promises (binary) or end before
/// `endsolid` (text): importers take such files without a word.
void check_stl_is_whole(const std::filesystem::path& file, const std::string& bytes);

}  // namespace diefill::geometry
