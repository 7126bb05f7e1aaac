// How often a surface goes round a point.
#pragma once

#include <vector>

#include "geometry/triangle.h"

namespace diefill::geometry {

/// Winding number of a surface about `point` (m): 1 inside a closed, outward surface, 0 outside; in between
/// where the surface has holes (Jacobson, Kavan and Sorkine-Hornung 2013). Sums over all triangles: for the
/// odd hard case.
double winding_number(const std::vector<Corners>& triangles, const Eigen::Vector3d& point);

}  // namespace diefill::geometry
