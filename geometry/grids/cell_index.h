// Which cube of a division of space a place is in.
#pragma once

#include <Eigen/Core>

namespace diefill::geometry {

/// As std::floor, which calls a function where the processor's own is not to be relied on.
inline int rounded_down(double value) {
  const int near = static_cast<int>(value);
  return value < near ? near - 1 : near;
}

/// Number of the cube along each axis; `edges` is the place in lengths of an edge.
inline Eigen::Vector3i cube_of(const Eigen::Vector3d& edges) {
  return edges.unaryExpr(&rounded_down);
}

}  // namespace diefill::geometry
