// Walls of triangles from a line in a plane: drawn along y, or turned about z.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/walls/walls.h"

namespace diefill::process::laboratory {

/// Places (x or radius, z; m) that the boundary of the powder runs through, powder on its left.
using Profile = std::vector<Eigen::Vector2d>;

/// Adds the profile, drawn from y = -`half` to `half` (m).
void add_along_y(engine::WallBodySpec& body, const Profile& profile, double half);

/// Adds the profile, turned about z in 48 parts.
void add_about_z(engine::WallBodySpec& body, const Profile& profile);

}  // namespace diefill::process::laboratory
