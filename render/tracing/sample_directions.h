// Fixed directions of rays about a surface, different in each of 4 x 4 neighbouring pixels and evenly spread
// over all of them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace diefill::render {

/// Two numbers in [0, 1).
using Sample = std::array<float, 2>;

/// Point n of a sequence that fills the square evenly (Roberts 2018, R2: multiples of the plastic number's
/// powers).
inline Sample even_sample(std::uint32_t n) {
  // 2^32 over the plastic number and over its square; overflow is the fraction.
  const std::uint32_t x = n * 3242174889U, y = n * 2447445414U;
  return {static_cast<float>(x >> 8) * 0x1p-24F, static_cast<float>(y >> 8) * 0x1p-24F};
}

/// Two axes that stand upright on a unit vector (Duff et al. 2017).
inline std::array<Eigen::Vector3f, 2> axes_about(const Eigen::Vector3f& n) {
  const float sign = n.z() < 0 ? -1.0F : 1.0F, a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  return {Eigen::Vector3f(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()),
          Eigen::Vector3f(b, sign + n.y() * n.y() * a, -n.y())};
}

/// Direction over a surface, as often as its cosine with the normal is large.
Eigen::Vector3f cosine_direction(const Eigen::Vector3f& normal, const Sample& sample);

/// Direction within a cone about `axis` whose half angle has this tangent.
Eigen::Vector3f cone_direction(const Eigen::Vector3f& axis, float tangent, const Sample& sample);

}  // namespace diefill::render
