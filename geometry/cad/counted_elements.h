// Files whose head says how many corners and faces follow: whether they are all there, before an importer,
// which searches for what is missing, crashes, or repeats the last face, sees the file.
#pragma once

#include <string>

namespace diefill::geometry {

/// Throws MeshError, with `name` of the file, for a PLY file whose header has no end or whose elements are
/// not all there.
void check_ply_elements(const std::string& name, const std::string& bytes);

/// Throws MeshError for an OFF file that ends before its last face, a face with a corner that the file does
/// not define, or one with more corners than the importer takes. Files with several corners or faces a line
/// are left to the importer.
void check_off_elements(const std::string& name, const std::string& bytes);

}  // namespace diefill::geometry
