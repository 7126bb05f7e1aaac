#include "geometry/mesh/winding.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace diefill::geometry {

double solid_angle(const Corners& corners, const Eigen::Vector3d& eye) {
  const Eigen::Vector3d a = corners[0] - eye;
  const Eigen::Vector3d b = corners[1] - eye;
  const Eigen::Vector3d c = corners[2] - eye;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double winding_number(std::span<const Corners> triangles, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const Corners& corners : triangles) sum += solid_angle(corners, point);
  return sum / (4 * std::numbers::pi);
}

}  // namespace diefill::geometry
