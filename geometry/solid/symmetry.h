// Mirror planes and axes of rotation of a solid, found from its surface alone.
#pragma once

#include <string>
#include <vector>

#include "geometry/solid/solid_query.h"

namespace diefill::geometry {

/// A line that the solid can be turned about onto itself.
struct SymmetryAxis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  int order = 0;  ///< it looks the same this many times in a turn; 0: at every angle
};

/// What maps a solid onto itself.
struct Symmetry {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m, middle of the surface: on every plane and axis
  std::vector<Eigen::Vector3d> planes;               ///< normals of mirror planes
  std::vector<SymmetryAxis> axes;
  /// One line, such as "mirror planes across x and y; 4-fold about z through (0.00, 0.00) mm"; "none found".
  std::string description() const;
};

/// Searches along x, y, z and the principal axes of the surface. A mirror image counts as the same when no
/// point of the surface is farther than `tolerance` (m) from it; rotations up to 60-fold are distinguished.
/// Directions within a thousandth of a radian count as one. Deterministic.
Symmetry find_symmetry(const SolidQuery& solid, double tolerance);

}  // namespace diefill::geometry
