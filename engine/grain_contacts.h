// What touches what, read from the pair tables of the last step: for figures, messages and whatever else
// asks now and then. The pair loop itself streams the tables in its own way.
#pragma once

#include "engine/simulation.h"

namespace diefill::engine {

/// Calls visit(i, j, overlap) for every pair of spheres that overlapped in the last step, of which i and j
/// are the grains (places in Grains, never images); overlap in m. In the order of the blocks.
template <class Visit>
void visit_grain_contacts(const Simulation& simulation, const Visit& visit) {
  const SphereField& spheres = simulation.spheres();
  for (const Block& block : simulation.neighbours().blocks()) {
    const auto& table = block.grain_pairs;
    table.visit_touching([&](std::size_t p, const double*) {
      const std::size_t i = block.sphere(table.pair[p].own), j = block.sphere(table.pair[p].other);
      const std::size_t grain = spheres.owner(i), other = spheres.owner(j);
      const double reach =
          simulation.shape_of(grain).sphere_radius + simulation.shape_of(other).sphere_radius;
      const double overlap = reach - length(spheres.position(i) - spheres.position(j));
      if (overlap > 0) visit(grain, other, overlap);
    });
  }
}

}  // namespace diefill::engine
