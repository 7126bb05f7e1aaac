// How far a wall is from powder, to leave it out where it is far.
#pragma once

#include <Eigen/Geometry>

#include "engine/walls/walls.h"

namespace diefill::engine {

/// How far (m) the body at `pose` and the points in a box are apart at least, beyond `reach` (m); 0 when
/// near, and for planes. Coarse: the box counts as the ball about it.
double clearance_of(const WallBody& body, const BodyMotion& pose, const Eigen::AlignedBox3d& points,
                    double reach);

}  // namespace diefill::engine
