// How many simultaneous contacts to assume for a sphere pinched between two tools.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diefill::engine {

/// Of a sphere pinched under the edge of a shoe: at `overlap` (m) it meets several wall spheres of radius
/// `wall_radius` and distance `wall_spacing` (m) on either side at once, about pi 2 h (R + R_w) / s^2
/// (spheres whose overlap with a plane of them is positive) with half the overlap on average. A flat wall
/// (infinite `wall_radius`) is met once.
inline double pinching_contacts(double sphere_radius, double wall_radius, double wall_spacing,
                                double overlap) {
  if (std::isinf(wall_radius)) return 2;
  const double met =
      2 * std::numbers::pi * overlap * (sphere_radius + wall_radius) / (wall_spacing * wall_spacing);
  return 2 * (met > 1 ? std::max(1.0, 0.5 * met) : 1.0);
}

}  // namespace diefill::engine
