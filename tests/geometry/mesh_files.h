// The bytes of CAD files made of meshes, for tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry::sample {

/// The bytes of a file of each format; coordinates are written as they are.
std::string ascii_stl(const Mesh& mesh);
std::string binary_stl(const Mesh& mesh);
std::string obj(const Mesh& mesh);
std::string ply(const Mesh& mesh);
std::string binary_ply(const Mesh& mesh);
std::string off(const Mesh& mesh);
/// `unit` as AMF names it, such as "millimeter".
std::string amf(const Mesh& mesh, const std::string& unit);
/// Collada with z up; `unit` in metres.
std::string collada(const Mesh& mesh, double unit);
/// glTF in metres with y up, as its standard has it: x, y, z of the mesh are written as x, z, -y.
std::string gltf(const Mesh& mesh, const std::string& name);
/// The same as one binary file.
std::string glb(const Mesh& mesh, const std::string& name);

/// A mesh and what the file calls it.
using NamedMesh = std::pair<std::string, Mesh>;
/// The archive that 3MF files are; `unit` and the type of the last object as 3MF names them, such as
/// "millimeter" and "support".
std::string three_mf(const std::vector<NamedMesh>& parts, const std::string& unit,
                     const std::string& type_of_last = "model");
/// An archive of files that are not compressed.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files);
/// OBJ with one `o` a part, and text STL with one `solid` a part.
std::string obj_of_parts(const std::vector<NamedMesh>& parts);
std::string stl_of_parts(const std::vector<NamedMesh>& parts);

}  // namespace diefill::geometry::sample
