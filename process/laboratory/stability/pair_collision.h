// Two grains that meet head-on in empty space.
#pragma once

#include "engine/simulation/settings.h"

namespace diefill::process::laboratory {

struct PairCollision {
  bool parted = false;
  double rebound = 0;  ///< m/s, speed of separation; 0 while they hold together
  double energy = 0;   ///< J, kinetic and in normal springs, at the end
  double deepest = 0;  ///< m, largest overlap
  double time = 0;     ///< s, that it was watched
};

/// Grains fly at each other along x at relative speed `speed` (m/s), their centres on one line and arms
/// towards each other; `phase` (0 to 1): part of a step by which they are apart at the start. Watched until
/// they part by `range` (m), at most for `steps` steps.
PairCollision meet_head_on(const engine::SimulationSettings& settings, double speed, double phase, long steps,
                           double range = 0);

}  // namespace diefill::process::laboratory
