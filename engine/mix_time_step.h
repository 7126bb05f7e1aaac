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

/// The same among grains alone at overlaps of up to `overlap` (m) and `overlap_over_radius`, of the radius of
/// the smaller sphere: what a run checks itself against. Which pair reached them does not matter: no pair has
/// reached more.
double critical_time_step_at_overlap(const GrainMix& mix, double overlap, double overlap_over_radius);

}  // namespace diefill::engine
