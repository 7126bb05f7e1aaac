#include "tests/geometry/mesh_files.h"

#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace diefill::geometry::sample {

namespace {

template <typename Value>
void append(std::string& bytes, Value value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

const Eigen::Vector3d& corner(const Mesh& mesh, const Eigen::Vector3i& triangle, int k) {
  return mesh.vertices[static_cast<std::size_t>(triangle[k])];
}

}  // namespace

std::string ascii_stl(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9) << "solid sample\n";
  for (const Eigen::Vector3i& t : mesh.triangles) {
    out << "facet normal 0 0 0\n outer loop\n";
    for (int k = 0; k < 3; ++k) out << "  vertex " << corner(mesh, t, k).transpose() << "\n";
    out << " endloop\nendfacet\n";
  }
  out << "endsolid sample\n";
  return out.str();
}

std::string binary_stl(const Mesh& mesh) {
  std::string bytes = "solid in name only";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(corner(mesh, t, k)[axis]));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string obj(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9);
  for (const Eigen::Vector3d& v : mesh.vertices) out << "v " << v.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "f " << (t.array() + 1).transpose() << "\n";
  return out.str();
}

std::string ply(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9) << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& v : mesh.vertices) out << v.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "3 " << t.transpose() << "\n";
  return out.str();
}

}  // namespace diefill::geometry::sample
