// Triangle strips of PLY files, of which assimp 5.2 reads one triangle each.
#pragma once

#include <string>

namespace diefill::geometry {

/// The bytes of a PLY file with triangles in place of its strips (element `tristrips`, where -1 begins
/// another strip); other files stay as they are. Throws std::runtime_error where a file holds faces beside
/// strips, where a strip has more than a list of whole numbers, or ends early.
std::string with_faces_for_strips(std::string bytes);

}  // namespace diefill::geometry
