// The longest time step that a powder of several kinds allows, from the stiffest and lightest of its pairs.
#pragma once

#include "engine/powder/particle_types.h"

namespace diefill::engine {

/// A wall that grains of a mix meet.
struct MixWall {
  std::string material;
  double sphere_radius = 0;  ///< m; infinite for planes
};

/// Critical time step (s) of `mix` at impacts of `impact_speed` (m/s): the smallest over all pairs of kinds,
/// and of kinds with `walls`, of the limits of critical_time_step() in general_time_step.h, with the springs
/// and dampers of the pair's own law. One contact acts on the reduced masses of the pair at the overlap of
/// the impact, and so does the attraction; of kContactsPerGrain contacts at a tenth of that overlap the
/// springs alone, on half of the smaller grain, as if it lay among grains of its own size. So it is never
/// above that of the smallest grains among themselves. Where forces are scaled, moments of inertia are those
/// that torques balance with.
/// Throws what making the laws throws.
double critical_time_step(const GrainMix& mix, const std::vector<MixWall>& walls, double impact_speed);

/// The same among grains alone at overlaps of up to `overlap` (m) and `overlap_over_radius`, of the radius of
/// the smaller sphere: what a run checks itself against. Which pair reached them does not matter: no pair has
/// reached more.
double critical_time_step_at_overlap(const GrainMix& mix, double overlap, double overlap_over_radius);

}  // namespace diefill::engine
