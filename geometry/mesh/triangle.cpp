#include "geometry/mesh/triangle.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace diefill::geometry {

namespace {

constexpr double kFlatnessLimit = 1e-12;

using Kind = TriangleFeature::Kind;

}  // namespace

TriangleFoot closest_point(const Corners& corners, const Eigen::Vector3d& query) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d from_a = query - a;
  const double d1 = ab.dot(from_a);
  const double d2 = ac.dot(from_a);
  if (d1 <= 0 && d2 <= 0) return {a, {Kind::kCorner, 0}};

  const Eigen::Vector3d from_b = query - b;
  const double d3 = ab.dot(from_b);
  const double d4 = ac.dot(from_b);
  if (d3 >= 0 && d4 <= d3) return {b, {Kind::kCorner, 1}};

  const Eigen::Vector3d from_c = query - c;
  const double d5 = ab.dot(from_c);
  const double d6 = ac.dot(from_c);
  if (d6 >= 0 && d5 <= d6) return {c, {Kind::kCorner, 2}};

  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + ab * (d1 / (d1 - d3)), {Kind::kEdge, 0}};

  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + ac * (d2 / (d2 - d6)), {Kind::kEdge, 2}};

  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return {b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), {Kind::kEdge, 1}};

  const Eigen::Vector3d normal = ab.cross(ac).normalized();
  return {query - normal * normal.dot(from_a), {Kind::kFace, 0}};
}

std::size_t longest_edge(const Corners& corners) {
  const auto length = [&](std::size_t k) { return (corners[(k + 1) % 3] - corners[k]).norm(); };
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (length(k) > length(longest)) longest = k;
  return longest;
}

Eigen::Vector3d area_vector(const Corners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

bool is_degenerate(const Corners& corners) {
  const double longest_squared =
      std::max({(corners[1] - corners[0]).squaredNorm(), (corners[2] - corners[1]).squaredNorm(),
                (corners[0] - corners[2]).squaredNorm()});
  return area_vector(corners).norm() <= kFlatnessLimit * longest_squared;
}

}  // namespace diefill::geometry
