// The bytes of CAD files made of meshes, for tests.
#pragma once

#include <string>

#include "geometry/mesh.h"

namespace diefill::geometry::sample {

/// The bytes of a file of each format; coordinates are written as they are.
std::string ascii_stl(const Mesh& mesh);
std::string binary_stl(const Mesh& mesh);
std::string obj(const Mesh& mesh);
std::string ply(const Mesh& mesh);

}  // namespace diefill::geometry::sample
