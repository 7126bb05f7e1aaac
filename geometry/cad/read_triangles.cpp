#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <limits>
#include <map>
#include <regex>
#include <stdexcept>

#include "geometry/cad/amf_document.h"
#include "geometry/cad/cad_readers.h"
#include "geometry/cad/restricted_io.h"
#include "geometry/mesh/equal_vertices.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kHeadBytes = 4096;  // the root element of an AMF file is within so many

constexpr int kNoVertex = std::numeric_limits<int>::max() - 1;  // refused by whoever looks at the corners

/// Collects the meshes of a file by the names of their nodes.
class PartCollector {
 public:
  PartCollector(const aiScene& scene, std::vector<CadPart>& parts) : scene_(scene), parts_(parts) {}

  void add(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 pose = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], node, pose);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], pose);
  }

 private:
  /// The mesh's own name says more than that of the root, which some formats fill with the library's.
  std::string name_of(const aiMesh& mesh, const aiNode& node) const {
    if (&node != scene_.mRootNode && node.mName.length > 0) return node.mName.C_Str();
    return mesh.mName.C_Str();
  }

  void add(const aiMesh& piece, const aiNode& node, const aiMatrix4x4& pose) {
    // Meshes of one node are one part: formats split them by material.
    CadPart& part =
        part_of(&node == scene_.mRootNode ? static_cast<const void*>(&piece) : &node, name_of(piece, node));
    Mesh& mesh = part.mesh;
    // assimp gives most triangles corners of their own: six times the vertices that there are.
    EqualVertices places;
    std::vector<int> vertex(piece.mNumVertices);
    const int offset = static_cast<int>(mesh.vertices.size());
    for (unsigned i = 0; i < piece.mNumVertices; ++i) {
      const aiVector3D placed = pose * piece.mVertices[i];
      vertex[i] = offset + static_cast<int>(places.add({placed.x, placed.y, placed.z}));
    }
    mesh.vertices.insert(mesh.vertices.end(), places.places().begin(), places.places().end());
    // A mirroring pose reverses the triangles' orientation; swapping two corners restores it.
    const bool mirrored = pose.Determinant() < 0;
    for (unsigned i = 0; i < piece.mNumFaces; ++i) {
      const aiFace& face = piece.mFaces[i];
      if (face.mNumIndices != 3) continue;
      const auto corner = [&](unsigned k) {
        return face.mIndices[k] < vertex.size() ? vertex[face.mIndices[k]] : kNoVertex;
      };
      mesh.triangles.emplace_back(corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2));
    }
  }

  CadPart& part_of(const void* owner, const std::string& name) {
    const auto [place, is_new] = index_.try_emplace(owner, parts_.size());
    if (is_new) parts_.push_back({name, {}});
    return parts_[place->second];
  }

  const aiScene& scene_;
  std::vector<CadPart>& parts_;
  std::map<const void*, std::size_t> index_;  // only ever looked up
};

/// x, y up, z becomes x, -z, y: z points up, as in every scene.
void turn_z_up(Mesh& mesh) {
  for (Eigen::Vector3d& v : mesh.vertices) v = Eigen::Vector3d(v.x(), -v.z(), v.y());
}

/// assimp leaves AMF coordinates as they are and does not pass the unit on.
double amf_unit(const std::string& document) {
  const std::string head = document.substr(0, kHeadBytes);
  static const std::map<std::string, double> units = {
      {"millimeter", 1e-3}, {"inch", 0.0254}, {"feet", 0.3048}, {"meter", 1}, {"micron", 1e-6}};
  std::smatch found;
  static const std::regex unit("<amf[^>]*\\sunit\\s*=\\s*[\"']([a-zA-Z]*)[\"']");
  if (!std::regex_search(head, found, unit)) return 1e-3;  // the default of ISO/ASTM 52915
  const auto known = units.find(found[1]);
  if (known == units.end()) throw std::runtime_error("its unit '" + found[1].str() + "' is not an AMF unit");
  return known->second;
}

bool y_points_up(const std::string& ending) {
  return ending == "gltf" || ending == "glb" || ending == "dae";
}

}  // namespace

CadParts read_triangles(const std::filesystem::path& file, const CadFormat& format) {
  Assimp::Importer importer;
  auto* const files = new RestrictedIo(file, format.ending);
  importer.SetIOHandler(files);  // which it deletes
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    if (!files->refused().empty()) throw std::runtime_error(files->refused());
    const std::string words = importer.GetErrorString();
    throw std::runtime_error(words.empty() ? "the importer does not support its internal layout"
                                           : words.substr(0, words.find('\n')));
  }
  CadParts contents;
  PartCollector(*scene, contents.parts).add(*scene->mRootNode, aiMatrix4x4());
  if (y_points_up(format.ending)) {
    for (CadPart& part : contents.parts) turn_z_up(part.mesh);
    contents.metres_per_unit = 1;  // glTF by its standard; Collada's own unit is applied by the importer
  }
  if (format.ending == "amf") {
    const std::string document = amf_document(file);
    contents.metres_per_unit = amf_unit(document);
    contents.parts = placed_amf_objects(document, std::move(contents.parts));
  }
  return contents;
}

}  // namespace diefill::geometry
