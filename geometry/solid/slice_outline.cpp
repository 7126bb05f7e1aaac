#include "geometry/solid/slice_outline.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace diefill::geometry {
namespace {

// The two points in which the plane cuts the triangle's edges; false when it passes above or below.
bool cut(const std::array<Eigen::Vector3d, 3>& corners, double height, std::array<Eigen::Vector2d, 2>& ends) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& one = corners[i];
    const auto& other = corners[(i + 1) % 3];
    if ((one.z() > height) == (other.z() > height)) continue;
    const double part = (height - one.z()) / (other.z() - one.z());
    ends[found++] = (one + part * (other - one)).head<2>();
  }
  return found == 2;
}

}  // namespace

std::vector<OutlinePiece> slice_outline(const Mesh& mesh, double height, double longest) {
  std::vector<OutlinePiece> outline;
  for (const auto& triangle : mesh.triangles) {
    const std::array<Eigen::Vector3d, 3> corners = {mesh.vertices[static_cast<std::size_t>(triangle[0])],
                                                    mesh.vertices[static_cast<std::size_t>(triangle[1])],
                                                    mesh.vertices[static_cast<std::size_t>(triangle[2])]};
    std::array<Eigen::Vector2d, 2> ends;
    if (!cut(corners, height, ends)) continue;
    const Eigen::Vector2d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).head<2>();
    const double length = (ends[1] - ends[0]).norm();
    if (normal.norm() == 0 || length == 0) continue;
    const int pieces = static_cast<int>(std::ceil(length / longest));
    const Eigen::Vector2d step = (ends[1] - ends[0]) / pieces;
    for (int i = 0; i < pieces; ++i) {
      outline.push_back({ends[0] + i * step, ends[0] + (i + 1) * step, normal.normalized()});
    }
  }
  return outline;
}

}  // namespace diefill::geometry
