// The longest stable time step of a mass between springs and dampers.
#pragma once

#include <cmath>

namespace diefill::engine {

/// Longest stable time step (s) of a `mass` (kg) between springs of total `stiffness` (N/m) and dampers of
/// total `damping` (kg/s). Velocity Verlet with the damper's force at the velocity predicted from the force
/// at the start of the step (OP-3) reaches its stability limit where k dt^2 / (4 m) + c dt / m = 1: without
/// dampers 2 sqrt(m / k), without springs m / c, half of what the exact velocity would allow.
inline double stable_step(double mass, double stiffness, double damping) {
  const double decay = damping / mass;
  return 2 / (decay + std::sqrt(decay * decay + stiffness / mass));
}

}  // namespace diefill::engine
