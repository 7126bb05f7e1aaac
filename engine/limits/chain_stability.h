// Whether a time step carries grains that are wedged: between two tools a grain may lean on a dozen wall
// spheres and neighbours at once, and what is stable for one contact is not for all of them together.
#pragma once

#include <vector>

#include "engine/simulation/simulation.h"

namespace diefill::engine {

/// How much of the time step's stability a group of grains uses up, and where.
struct StabilityUse {
  double used = 0;        ///< from 1 on the integration swings up
  std::size_t grain = 0;  ///< the one of the group that swings most (place in Grains)
};

/// For `grains` (places in Grains) with all contacts that they have, among each other and with what stands
/// fast around them: the largest eigenvalue of k dt^2 / 4 + c dt over the grains' masses and moments of
/// inertia, for normal springs k and dampers c of the last step's contacts (stable_step.h has the same of one
/// mass). Friction is left out: what is wedged slides. Looks at those blocks of the pair tables that the
/// grains are in.
StabilityUse stability_used(const Simulation& simulation, const std::vector<std::size_t>& grains);

}  // namespace diefill::engine
