// Binary STL without a library. assimp reads it too, but allocates several objects per triangle and needs a
// child process: the import of ten million triangles took 10 s, a sixth of what `diefill check` of them may
// take, and takes 4 s here. This reader trusts no number of the file but its length, so it needs no child
// process.
#pragma once

#include <string>

#include "geometry/cad/cad_parts.h"

namespace diefill::geometry {

/// Whether `bytes` hold the triangles that their header promises, at least one. More bytes may follow; a
/// header with 0 or the largest number counts as never filled in. Text must be recognised in advance.
bool is_binary_stl(const std::string& bytes);

/// All triangles of a binary STL file as one part, in the order of the file, equal corners once. Files one
/// behind another, as some programs write several solids, are a part each. Bytes left over are remarked on.
CadParts read_binary_stl(const std::string& bytes);

}  // namespace diefill::geometry
