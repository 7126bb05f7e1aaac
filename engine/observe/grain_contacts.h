// Which grains touch, read from the pair tables of the last step.
#pragma once

#include "engine/observe/block_contacts.h"

namespace diefill::engine {

/// Calls visit(i, j, overlap) for every pair of spheres that overlapped in the last step, of which i and j
/// are the grains (places in Grains, never images); overlap in m. In the order of the blocks.
template <class Visit>
void visit_grain_contacts(const Simulation& simulation, const Visit& visit) {
  const SphereField& spheres = simulation.spheres();
  for (const Block& block : simulation.neighbours().blocks())
    visit_sphere_touches(simulation, block, [&](const SphereTouch& touch) {
      visit(spheres.owner(touch.sphere), spheres.owner(touch.other), touch.overlap);
    });
}

}  // namespace diefill::engine
