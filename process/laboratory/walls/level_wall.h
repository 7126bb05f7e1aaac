// A level wall at z = 0 in both kinds: wall spheres, or triangles, which are the surface itself.
#pragma once

#include <functional>
#include <string>

#include "engine/simulation/settings.h"
#include "engine/walls/walls.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

/// Wall spheres on a square grid, their tops at z = 0.
struct SphereGrid {
  double radius = 1.5e-4;  ///< m, R_w
  double spacing = 1.6;    ///< over R_w
};

/// Those spheres of the grid within `half_width` (m) along x and y whose centre `wanted` (m) keeps.
engine::WallBodySpec level_spheres(
    const SphereGrid& grid, double half_width,
    const std::function<bool(const Eigen::Vector3d&)>& wanted = [](const Eigen::Vector3d&) { return true; });

/// Two triangles over the same width.
engine::WallBodySpec level_mesh(double half_width);

/// Bierwisch's sphere (model A, 2009, Table C.4), weightless, with walls of its own material and friction.
engine::SimulationSettings single_sphere(double damping_over_radius, double friction);

/// Radii of wall spheres over the grain's that charts have a curve for: from fine spheres to those of 0.15 mm
/// under the finest grains of model D.
inline constexpr double kRadiusRatios[] = {0.25, 0.5, 1, 2};

/// "R_w = 0.5 R".
std::string description(double radius_ratio);

}  // namespace diefill::process::laboratory
