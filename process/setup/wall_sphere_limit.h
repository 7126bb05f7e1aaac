// Number of wall spheres that tools may take: predicted before any is placed, so that a radius far too small
// is refused at once.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// Wall spheres of all tools at most.
inline constexpr double kMaxWallSpheres = 2e6;

/// Throws SceneError where a tool would take too many wall spheres for what powder reaches of it.
void refuse_too_many_wall_spheres(
    const Scene& scene, const Tooling& tooling,
    const std::function<bool(std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&)>& reachable);

}  // namespace diefill::process
