// A flat triangle of a tool's surface, and where it is nearest to a grain.
#pragma once

#include <Eigen/Core>
#include <array>

namespace diefill::engine {

/// Corners (m, body frame) are counter-clockwise seen from the side where powder is.
struct WallTriangle {
  std::array<Eigen::Vector3d, 3> corner;

  /// Unit vector towards the powder; not finite where the corners lie on a line.
  Eigen::Vector3d normal() const { return (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized(); }
};

/// The point of a triangle nearest to some place.
struct NearestPoint {
  Eigen::Vector3d point;  ///< m
  bool inside = false;    ///< on neither edge nor corner: straight below the place
};

/// The point of `triangle` nearest to `place` (m); by the regions of its plane that faces, edges and corners
/// are nearest in (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
NearestPoint nearest_point(const WallTriangle& triangle, const Eigen::Vector3d& place);

}  // namespace diefill::engine
