// What a simulation takes over from another program, such as one that runs on many machines: steps, and the
// state of the powder at one of them. Grains are identified by their ids, because each side has its own
// order.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/deepest_overlap.h"
#include "engine/powder/grains.h"
#include "engine/simulation/energy_ledger.h"

namespace diefill::engine {

class Simulation;
struct WallLoad;

/// Figures of one step.
struct ComputedStep {
  /// J, of this step: damping, friction, air and rolling. The work of tools follows from their loads.
  Ledger work;
  DeepestOverlap overlap;       ///< m
  std::uint64_t touching = 0;   ///< pairs
  std::vector<WallLoad> loads;  ///< on the bodies
};

/// Touching pairs of grains, or of grains with walls, by names that stay valid when grains are sorted.
struct NamedContacts {
  struct Pair {
    std::uint64_t grain;  ///< id
    /// Id of the other grain; at walls the number of the wall sphere or plane, all bodies counted through.
    std::uint64_t other;
    std::uint32_t sphere, other_sphere;  ///< of the grains; the second means nothing at walls
  };
  std::vector<Pair> pair;
  std::vector<double> history;  ///< of each, one pair after the other, seen from `grain`
};

/// The contacts that a simulation has now.
NamedContacts grain_contacts(const Simulation& simulation);
NamedContacts wall_contacts(const Simulation& simulation);

}  // namespace diefill::engine
