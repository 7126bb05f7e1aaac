#include "geometry/mesh/mesh.h"

#include <Eigen/Geometry>

namespace diefill::geometry {

void Box::include(const Eigen::Vector3d& point) {
  lower = lower.cwiseMin(point);
  upper = upper.cwiseMax(point);
}

void Box::include(const Box& other) {
  lower = lower.cwiseMin(other.lower);
  upper = upper.cwiseMax(other.upper);
}

bool Box::contains(const Eigen::Vector3d& point) const {
  return (point.array() >= lower.array()).all() && (point.array() <= upper.array()).all();
}

Box Mesh::bounding_box() const {
  Box box;
  for (const auto& vertex : vertices) box.include(vertex);
  return box;
}

double Mesh::volume() const {
  double six_volumes = 0;
  for (const auto& triangle : triangles) {
    const auto& a = vertices[static_cast<std::size_t>(triangle[0])];
    const auto& b = vertices[static_cast<std::size_t>(triangle[1])];
    const auto& c = vertices[static_cast<std::size_t>(triangle[2])];
    six_volumes += a.dot(b.cross(c));
  }
  return six_volumes / 6;
}

Mesh transformed(const Mesh& mesh, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) {
  Mesh result = mesh;
  for (auto& vertex : result.vertices) vertex = rotation * vertex + translation;
  return result;
}

}  // namespace diefill::geometry
