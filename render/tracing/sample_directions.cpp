#include "render/tracing/sample_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diefill::render {
namespace {

/// Even in the unit disc.
std::array<float, 2> in_disc(const Sample& sample) {
  const float radius = std::sqrt(sample[0]), angle = 2 * std::numbers::pi_v<float> * sample[1];
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Eigen::Vector3f cosine_direction(const Eigen::Vector3f& normal, const Sample& sample) {
  const auto [x, y] = in_disc(sample);
  const auto [first, second] = axes_about(normal);
  return x * first + y * second + std::sqrt(std::max(0.0F, 1 - sample[0])) * normal;
}

Eigen::Vector3f cone_direction(const Eigen::Vector3f& axis, float tangent, const Sample& sample) {
  const auto [x, y] = in_disc(sample);
  const auto [first, second] = axes_about(axis);
  return (axis + tangent * (x * first + y * second)).normalized();
}

}  // namespace diefill::render
