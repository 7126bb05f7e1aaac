// Reads CAD files (STL ASCII and binary, OBJ, PLY, 3MF where assimp reads it) into a Mesh in metres.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh.h"

namespace diefill::geometry {

/// Reads `file`, whose coordinates are in units of `metres_per_unit` (0.001 for mm). Vertices closer than
/// 1e-7 of the bounding box's diagonal are joined; all meshes of a file become one, placed by their
/// transformations. Throws MeshError when the file is missing, a directory, empty, cut short, of unknown
/// format, or holds no triangles or coordinates that are not finite.
Mesh import_mesh(const std::filesystem::path& file, double metres_per_unit);

/// Hash of the bytes of a file, as 16 hexadecimal digits, so that results can name the CAD they were made
/// with. Throws MeshError when the file cannot be read.
std::string file_hash(const std::filesystem::path& file);

}  // namespace diefill::geometry
