// How fast two groups of grains drift past each other.
#pragma once

#include <Eigen/Core>
#include <array>

namespace diefill::engine {

/// m/s, of the second group against the first; `drift`: mean velocity (m/s) of each.
inline double passing_speed(const std::array<Eigen::Vector3d, 2>& drift) {
  return (drift[1] - drift[0]).norm();
}

}  // namespace diefill::engine
