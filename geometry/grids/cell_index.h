// The cell of a cubic grid that a point lies in.
#pragma once

#include <Eigen/Core>

namespace diefill::geometry {

/// As std::floor, which is a function call where the processor's own instruction may not be used.
inline int rounded_down(double value) {
  const int near = static_cast<int>(value);
  return value < near ? near - 1 : near;
}

/// Index of the cell along each axis; `edges` is the point in cell edges.
inline Eigen::Vector3i cube_of(const Eigen::Vector3d& edges) {
  return edges.unaryExpr(&rounded_down);
}

}  // namespace diefill::geometry
