// Whether all points are distinct: checked for meshes of millions of vertices before they are merged one by
// one.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::geometry {

/// True only where no two of the points (m, finite) are within `distance` (m) of each other; may be false
/// where that would take too long to find out. On all cores.
bool surely_distinct(const std::vector<Eigen::Vector3d>& points, double distance);

}  // namespace diefill::geometry
