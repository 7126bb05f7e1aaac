#include "engine/walls/wall_triangle.h"

namespace diefill::engine {

NearestPoint nearest_point(const WallTriangle& triangle, const Eigen::Vector3d& place) {
  const auto& [a, b, c] = triangle.corner;
  const Eigen::Vector3d ab = b - a, ac = c - a, from_a = place - a;
  const double ab_a = ab.dot(from_a), ac_a = ac.dot(from_a);
  if (ab_a <= 0 && ac_a <= 0) return {a};

  const Eigen::Vector3d from_b = place - b;
  const double ab_b = ab.dot(from_b), ac_b = ac.dot(from_b);
  if (ab_b >= 0 && ac_b <= ab_b) return {b};

  const double beyond_ab = ab_a * ac_b - ab_b * ac_a;
  if (beyond_ab <= 0 && ab_a >= 0 && ab_b <= 0) return {a + ab_a / (ab_a - ab_b) * ab};

  const Eigen::Vector3d from_c = place - c;
  const double ab_c = ab.dot(from_c), ac_c = ac.dot(from_c);
  if (ac_c >= 0 && ab_c <= ac_c) return {c};

  const double beyond_ac = ab_c * ac_a - ab_a * ac_c;
  if (beyond_ac <= 0 && ac_a >= 0 && ac_c <= 0) return {a + ac_a / (ac_a - ac_c) * ac};

  const double beyond_bc = ab_b * ac_c - ab_c * ac_b;
  const double along_b = ac_b - ab_b, along_c = ab_c - ac_c;
  if (beyond_bc <= 0 && along_b >= 0 && along_c >= 0) return {b + along_b / (along_b + along_c) * (c - b)};

  const double whole = 1 / (beyond_ab + beyond_ac + beyond_bc);
  return {a + beyond_ac * whole * ab + beyond_ab * whole * ac, true};
}

}  // namespace diefill::engine
