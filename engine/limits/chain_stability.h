// Whether a time step is stable for wedged grains: between two tools a grain may touch a dozen wall spheres
// and neighbours at once, and a step that is stable for one contact may not be for all of them together.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::engine {

class Simulation;

/// How close a group of grains comes to the stability limit of the time step, and where.
struct StabilityUse {
  double used = 0;        ///< from 1 on the integration is unstable
  std::size_t grain = 0;  ///< the one of the group with the largest amplitude (place in Grains)
};

/// For `grains` (places in Grains) with all their contacts, among each other and with what is around them,
/// taken as fixed: the largest eigenvalue of k dt^2 / 4 + c dt over the grains' masses and moments of
/// inertia, for normal springs k and dampers c of the last step's contacts (stable_step.h has the same of one
/// mass). Friction is left out: what is wedged slides. Looks at those blocks of the pair tables that the
/// grains are in.
StabilityUse stability_used(const Simulation& simulation, const std::vector<std::size_t>& grains);

}  // namespace diefill::engine
