// How deep the surface of one part reaches into another.
#pragma once

#include "geometry/solid/solid_query.h"

namespace diefill::geometry {

struct Penetration {
  double depth = 0;  ///< m below the solid's surface; 0 where the two do not overlap
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m
};

/// The point of `part` that lies deepest inside `solid`, whose mesh lies in `box`. No other is deeper by more
/// than `resolution` (m). Triangles are halved where a deeper point may lie: a distance changes by no more
/// than the way gone, so most are ruled out by the distance at their middle.
Penetration deepest_penetration(const Mesh& part, const SolidQuery& solid, const Box& box, double resolution);

}  // namespace diefill::geometry
