// Winding number: how often a surface encloses a point.
#pragma once

#include <span>

#include "geometry/mesh/triangle.h"

namespace diefill::geometry {

/// Solid angle (sr) of a triangle seen from `eye` (m), positive when seen from behind (Van Oosterom and
/// Strackee 1983).
double solid_angle(const Corners& corners, const Eigen::Vector3d& eye);

/// Winding number of a surface about `point` (m): 1 inside a closed, outward surface, 0 outside; in between
/// where the surface has holes (Jacobson, Kavan and Sorkine-Hornung 2013). Sums over all triangles: for rare
/// difficult cases.
double winding_number(std::span<const Corners> triangles, const Eigen::Vector3d& point);

}  // namespace diefill::geometry
