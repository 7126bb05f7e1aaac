// Contact forces of one block: computed from its pairs, and gathered from all blocks for its grains.
#pragma once

#include "engine/simulation/simulation_state.h"

namespace diefill::engine {

/// Contact forces of the pairs of block b into its sums and its tally. `workspace`: of the calling thread.
void compute_block(SimulationState& state, std::size_t b, BlockWorkspace& workspace,
                   OtherBlocks others = OtherBlocks::wait);

/// Turns `contacts`, the sums of the pairs of block b, into contact forces on its grains, moments about their
/// centres: adds those of other blocks' pairs, in block order. `contacts` may be the block's own.
/// `places(block)`: positions (m) of all grains for which the sums of that block were computed.
template <class Places>
void gather(const SimulationState& state, std::size_t b, ContactSums& contacts, const Places& places) {
  const NeighbourList& list = state.list;
  const Block& own = list.blocks()[b];
  const bool clumps = state.types.clumps();
  if (clumps)
    for (std::size_t k = 0; k < own.grains(); ++k) {
      const Vector3 arm = plain(places(b)[own.begin + k]) - plain(own.reference);
      contacts.add_moment(k, -cross(arm, contacts.force(k)));
    }
  constexpr std::uint32_t kAhead = 32;  // sums of other blocks lie anywhere: they are prefetched
  const std::uint32_t end = list.foreign_first()[b + 1];
  for (std::uint32_t f = list.foreign_first()[b]; f < end; ++f) {
    if (f + kAhead < end) {
      const auto& soon = list.foreign_sums()[f + kAhead];
      list.blocks()[soon.block].sums.fetch(soon.slot);
      contacts.fetch(soon.grain);
    }
    const auto& place = list.foreign_sums()[f];
    const Block& block = list.blocks()[place.block];
    const Vector3 force = block.sums.force(place.slot);
    Vector3 moment = block.sums.moment(place.slot);
    if (clumps) {
      const std::uint32_t seen = block.seen[place.slot - block.grains()];
      const Vector3 arm = plain(places(place.block)[own.begin + place.grain]) + state.spheres.shift(seen) -
                          plain(block.reference);
      moment = moment - cross(arm, force);
    }
    contacts.add_force(place.grain, force);
    contacts.add_moment(place.grain, moment);
    contacts.add_rolling_load(place.grain, block.sums.rolling_load(place.slot));
  }
}

}  // namespace diefill::engine
