// The outline that a horizontal plane cuts out of a solid.
#pragma once

#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// A straight piece of an outline, m; `normal` points out of the solid, horizontal, length 1.
struct OutlinePiece {
  Eigen::Vector2d from, to, normal;
  Eigen::Vector2d middle() const { return (from + to) / 2; }
  double length() const { return (to - from).norm(); }
};

/// The pieces in which the plane at `height` (m) cuts the closed, outward `mesh`, none longer than `longest`
/// (m).
std::vector<OutlinePiece> slice_outline(const Mesh& mesh, double height, double longest);

}  // namespace diefill::geometry
