// Binary STL without a library. assimp reads it too, but makes nine objects in memory of each triangle, for
// which the importer needs a process of its own: 6.2 s for ten million triangles, a tenth of the time that
// `diefill check` may take. Here no number of the file but its length is trusted, so that no such process is
// needed.
#pragma once

#include <string>

#include "geometry/cad_parts.h"

namespace diefill::geometry {

/// Whether `bytes` are as many as the number of triangles in their header asks for, at least one: what assimp
/// takes for binary STL.
bool is_binary_stl(const std::string& bytes);

/// All triangles of a binary STL file as one part, in the order of the file, equal corners once.
CadParts read_binary_stl(const std::string& bytes);

}  // namespace diefill::geometry
