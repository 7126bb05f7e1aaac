// How long a step may be for a mass between springs and dampers.
#pragma once

#include <cmath>

namespace diefill::engine {

/// Longest time step (s) in which a `mass` (kg) between springs of `stiffness` (N/m) and dampers of `damping`
/// (kg/s) in all does not swing up. Velocity Verlet with the damper's force at the velocity that the step's
/// first force leads to (OP-3) turns over from step to step where k dt^2 / (4 m) + c dt / m = 1: without
/// dampers 2 sqrt(m / k), without springs m / c, half of what the exact velocity would allow.
inline double stable_step(double mass, double stiffness, double damping) {
  const double decay = damping / mass;
  return 2 / (decay + std::sqrt(decay * decay + stiffness / mass));
}

}  // namespace diefill::engine
