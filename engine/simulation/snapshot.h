// A snapshot: everything that a run needs to resume bit for bit as if it had never stopped.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/deepest_overlap.h"
#include "engine/powder/grains.h"
#include "engine/search/neighbour_list.h"
#include "engine/simulation/energy_ledger.h"
#include "engine/simulation/sleeping.h"

namespace diefill::engine {

/// Snapshot of a Simulation. Pair tables are not kept: they are found again from `reference`, in the same
/// order, and `grain_history`, `wall_history` name the touching pairs by their place in them.
struct Snapshot {
  std::uint64_t step = 0;
  double time = 0;  ///< s
  Grains grains;
  ListReference reference;
  /// Touching pairs: number of each over all blocks, in block order, and its history, pair after pair.
  struct History {
    std::vector<std::uint64_t> pair;
    std::vector<double> value;
  };
  History grain_history, wall_history;
  Ledger ledger;
  std::uint64_t next_id = 0;
  DeepestOverlap overlap;  ///< m, over the whole run
  SleepState sleep;        ///< empty where no grains are put to sleep
};

/// 64-bit FNV-1a hash of the powder's state, grain by grain in the order of their ids: equal exactly if step
/// and all positions, orientations, velocities and spins are equal bit for bit, and types are where there are
/// several.
std::uint64_t state_hash(std::uint64_t step, const Grains& grains);

}  // namespace diefill::engine
