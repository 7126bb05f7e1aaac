#include "geometry/mesh_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <sstream>

#include "geometry/cad_file.h"
#include "geometry/point_grid.h"

namespace diefill::geometry {

namespace {

/// Vertices closer than this part of the bounding box's diagonal are one: CAD files carry single precision,
/// whose steps are 6e-8 of a coordinate, so that copies of one corner can differ by about as much.
constexpr double kJoinTolerance = 1e-7;

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void add_mesh(const aiMesh& part, const aiMatrix4x4& pose, Mesh& mesh) {
  const int offset = static_cast<int>(mesh.vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D placed = pose * part.mVertices[i];
    mesh.vertices.emplace_back(placed.x, placed.y, placed.z);
  }
  // A mirroring pose turns the triangles' sense round; swapping two corners turns it back.
  const bool mirrored = pose.Determinant() < 0;
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;
    const auto corner = [&](unsigned k) { return offset + static_cast<int>(face.mIndices[k]); };
    mesh.triangles.emplace_back(corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2));
  }
}

void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, Mesh& mesh) {
  const aiMatrix4x4 pose = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) add_mesh(*scene.mMeshes[node.mMeshes[i]], pose, mesh);
  for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], pose, mesh);
}

/// Vertices within tolerance of an earlier one become that one; vertices without triangles go.
Mesh with_joined_vertices(const Mesh& mesh) {
  const double tolerance = kJoinTolerance * mesh.bounding_box().size().norm();
  PointGrid kept(2 * tolerance);
  std::vector<int> kept_index(mesh.vertices.size(), -1);
  Mesh result;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Vector3i corners;
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(triangle[k]);
      if (kept_index[vertex] < 0) {
        std::size_t same = kept.nearest_within(mesh.vertices[vertex], tolerance);
        if (same == PointGrid::kNone) same = kept.insert(mesh.vertices[vertex]);
        kept_index[vertex] = static_cast<int>(same);
      }
      corners[k] = kept_index[vertex];
    }
    result.triangles.push_back(corners);
  }
  result.vertices = kept.points();
  return result;
}

void check_finite(const Mesh& mesh, const std::filesystem::path& file) {
  const auto bad = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                [](const Eigen::Vector3d& v) { return !v.allFinite(); });
  if (bad != mesh.vertices.end())
    throw MeshError("CAD file '" + file.string() + "' holds a corner that is no finite number (corner " +
                    std::to_string(bad - mesh.vertices.begin() + 1) + "): export it again");
}

/// The importer's own words, its first line; it says nothing about 3MF archives whose layout it does not
/// know.
std::string reason(const std::string& importer_error) {
  if (importer_error.empty()) return "its inner layout is not known to the importer";
  return importer_error.substr(0, importer_error.find('\n'));
}

}  // namespace

Mesh import_mesh(const std::filesystem::path& file, double metres_per_unit) {
  if (!(std::isfinite(metres_per_unit) && metres_per_unit > 0))
    throw MeshError("CAD file '" + file.string() +
                    "': the unit of length must be a positive number of metres, not " +
                    std::to_string(metres_per_unit));
  const std::string extension = extension_of(file);
  const std::string bytes = read_cad_file(file);
  if (extension != "stl" && extension != "obj" && extension != "ply" && extension != "3mf")
    throw MeshError("CAD file '" + file.string() + "' is of an unknown format '" + extension +
                    "': export it as STL, OBJ, PLY or 3MF");
  if (extension == "stl") check_stl_is_whole(file, bytes);

  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw MeshError("CAD file '" + file.string() + "' cannot be read as " + extension + ": " +
                    reason(importer.GetErrorString()) + "; export it again, best as STL");
  Mesh mesh;
  add_node(*scene, *scene->mRootNode, aiMatrix4x4(), mesh);
  if (mesh.triangles.empty())
    throw MeshError("CAD file '" + file.string() +
                    "' holds no triangles: export the solid as a surface mesh");
  check_finite(mesh, file);
  mesh = with_joined_vertices(mesh);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= metres_per_unit;
  return mesh;
}

std::string file_hash(const std::filesystem::path& file) {
  // FNV-1a, 64 bit (Fowler, Noll and Vo; RFC 9923).
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : read_cad_file(file)) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3U;
  }
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << hash;
  return text.str();
}

}  // namespace diefill::geometry
