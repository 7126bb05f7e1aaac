// What a simulation is made of, worked out from its settings when it is made. All throw std::invalid_argument
// for settings that cannot work.
#pragma once

#include "engine/contact/pair_loop.h"
#include "engine/powder/particle_types.h"
#include "engine/search/adaptive_skin.h"
#include "engine/search/neighbour_list.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

/// The kinds as they move: where forces are scaled, with the moments of inertia that torques balance with.
KindTable kinds_of(const SimulationSettings& settings);

/// The settings as the simulation keeps them: with the lever arm that such grains have, and the shape of the
/// first kind.
SimulationSettings checked(SimulationSettings settings, const KindTable& kinds);

std::unique_ptr<PairLoop> grain_loop_for(const SimulationSettings& settings, const KindTable& kinds);
std::unique_ptr<PairLoop> wall_loop_for(const SimulationSettings& settings, const KindTable& kinds,
                                        const std::vector<WallBodySpec>& walls);

/// Number of the first wall sphere, plane or triangle of each body, and of one beyond the last.
std::vector<std::uint32_t> first_sphere_of_bodies(const std::vector<WallBodySpec>& walls);
NeighbourSettings neighbour_settings(const KindTable& kinds, const PairLoop& grain_loop,
                                     const PairLoop& wall_loop);

/// The skin for these settings: no grain may come to meet another, or itself, from two sides of a period at
/// once. `range`: m, gap at which grains act on each other. Small grains are the many, so that it goes by
/// their size.
AdaptiveSkin skin_for(const SimulationSettings& settings, const KindTable& kinds, double range);

}  // namespace diefill::engine
