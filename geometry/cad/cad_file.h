// The bytes of a CAD file, checked before any importer sees them.
#pragma once

#include <filesystem>
#include <string>

namespace diefill::geometry {

/// All bytes of `file`. Throws MeshError when it is missing, no regular file (a directory, a pipe, a device),
/// larger than 1 GiB, not readable or empty.
std::string read_cad_file(const std::filesystem::path& file);

/// Throws MeshError when `bytes` of a file with this `ending` (lower case) are those of another format or
/// text in UTF-16, hold no triangles (binary STL) or fewer than a header promises (binary STL, PLY, OFF),
/// end before `endsolid` (text STL), or have a parameter such as nan (STEP): importers accept some such files
/// silently and ask for unlimited memory on others.
void check_content_matches_format(const std::filesystem::path& file, const std::string& ending,
                                  const std::string& bytes);

}  // namespace diefill::geometry
