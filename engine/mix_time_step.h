// The longest time step that a powder of several kinds allows, from the stiffest and lightest of its pairs.
#pragma once

#include "engine/grain_kinds.h"

namespace diefill::engine {

/// A wall that grains of a mix meet.
struct MixWall {
  std::string material;
  double sphere_radius = 0;  ///< m; infinite for planes
};

/// Critical time step (s) of `mix` at impacts of `impact_speed` (m/s): the smallest over all pairs of kinds,
/// and of kinds with `walls`, of 2 sqrt(m_eff / k) and 2 m_eff / c at the overlap of the impact, and, among
/// grains, 2 sqrt(m / (2 Z k)) of the lighter one at a tenth of that overlap: the limits of
/// critical_time_step() in time_step.h, with k and c from the law of the pair and masses lightened by
/// mobility(). Where forces are scaled, mobility is that of the moments of inertia that torques balance with.
/// Throws what making the laws throws.
double critical_time_step(const GrainMix& mix, const std::vector<MixWall>& walls, double impact_speed);

}  // namespace diefill::engine
