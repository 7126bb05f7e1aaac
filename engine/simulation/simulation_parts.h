// What a simulation is made of, worked out from its settings when it is made. All throw std::invalid_argument
// for settings that cannot work.
#pragma once

#include "engine/contact/pair_laws.h"
#include "engine/contact/pair_loop.h"
#include "engine/integrate/grain_integrator.h"
#include "engine/powder/particle_types.h"
#include "engine/search/adaptive_skin.h"
#include "engine/search/neighbour_list.h"
#include "engine/simulation/settings.h"

namespace diefill::engine {

/// The settings as the simulation keeps them: with the lever arm that such grains have, and types as they
/// move.
SimulationSettings checked(SimulationSettings settings, const ParticleTypes& types);

std::unique_ptr<PairLoop> grain_loop_for(const SimulationSettings& settings, const ParticleTypes& types);
std::unique_ptr<PairLoop> wall_loop_for(const SimulationSettings& settings, const ParticleTypes& types,
                                        const std::vector<WallBodySpec>& walls);

GrainIntegrator integrator_for(const SimulationSettings& settings, const ParticleTypes& types,
                               const PairLoop& grain_loop, const PairLoop& wall_loop);

/// The surfaces of bodies, as the laws of their contacts need them.
std::vector<WallSurface> surfaces_of(const std::vector<WallBody>& bodies);

/// Number of the first wall sphere, plane or triangle of each body, and of one beyond the last.
std::vector<std::uint32_t> first_sphere_of_bodies(const std::vector<WallBodySpec>& walls);
/// Offsets and classes of the spheres of all types; numbers without a sphere lie in the grain's centre.
void number_spheres_of_types(const ParticleTypes& types, SphereField& spheres);
NeighbourSettings neighbour_settings(const ParticleTypes& types, const PairLoop& grain_loop,
                                     const PairLoop& wall_loop);

/// The skin for these settings: no grain may come to meet another, or itself, from two sides of a period at
/// once. `range`: m, gap at which grains act on each other. Small grains are the many, so that it goes by
/// their size.
AdaptiveSkin skin_for(const SimulationSettings& settings, const ParticleTypes& types, double range);

}  // namespace diefill::engine
