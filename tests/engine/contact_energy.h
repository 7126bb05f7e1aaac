// What touching pairs hold, read from a simulation's pair tables: overlaps and energies of its contacts.
#pragma once

#include <cmath>

#include "engine/simulation/simulation.h"
#include "tests/support/contact_access.h"

namespace diefill::engine {

/// Calls visit(block, sphere i, pair number, history) for every touching grain pair; pairs of a block are
/// read in the order in which the engine streams them.
template <class Visit>
void visit_touching_grain_pairs(const Simulation& simulation, const Visit& visit) {
  for (const auto& block : simulation.neighbours().blocks()) {
    const auto& table = block.grain_pairs;
    table.visit_touching([&](std::size_t p, const double* history) {
      visit(block, block.sphere(table.pair[p].own), p, history);
    });
  }
}

/// Overlap (m) of sphere `i` with its partner in pair `p`.
inline double overlap_of(const Simulation& simulation, const Block& block, std::size_t i, std::size_t p) {
  const auto& spheres = simulation.spheres();
  return 2 * simulation.settings().shape().sphere_radius -
         length(spheres.position(i) - spheres.position(block.sphere(block.grain_pairs.pair[p].other)));
}

/// Tangential spring (m) in the history of a pair.
inline Eigen::Vector3d spring_of(const double* history) {
  return {history[0], history[1], history[2]};
}

/// Energy (J) in the tangential springs: 1/2 kappa_t sqrt(h / R_eff) xi^2 each.
inline double tangential_energy(const Simulation& simulation) {
  const auto& settings = simulation.settings();
  const double effective = 0.5 * settings.shape().sphere_radius;
  double energy = 0;
  visit_touching_grain_pairs(simulation, [&](const Block& block, std::size_t i, std::size_t p,
                                             const double* history) {
    energy += 0.5 * grain_contact(settings).tangential *
              std::sqrt(overlap_of(simulation, block, i, p) / effective) * spring_of(history).squaredNorm();
  });
  return energy;
}

}  // namespace diefill::engine
