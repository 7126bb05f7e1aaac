// The vertical plane across which tools, powder and motion are mirror images, so that a half model is
// possible.
#pragma once

#include <optional>
#include <vector>

#include "geometry/solid/symmetry.h"
#include "process/tooling/tooling.h"

namespace diefill::process::plan {

/// A symmetry plane of the tools, and what breaks the symmetry of the scene, if anything.
struct SymmetryPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
  double offset = 0;      ///< m, of the plane from the origin along the normal
  std::string asymmetry;  ///< empty: none; else what is not symmetric, such as "the motion: ..."
};

/// Vertical planes that all tools have in common within `tolerance` (m), from `symmetry` (one a tool), each
/// checked against gravity, the pour box, the periods and the steps' motions. Steps must have been prepared.
std::vector<SymmetryPlane> common_planes(const Scene& scene, const Tooling& tooling,
                                         const std::vector<geometry::Symmetry>& symmetry, double tolerance);

}  // namespace diefill::process::plan
