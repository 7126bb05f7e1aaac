// Which spheres touch: as the engine has found, and by brute force.
#pragma once

#include <cmath>
#include <set>
#include <utility>

#include "engine/simulation/simulation.h"
#include "tests/engine/contact_energy.h"

namespace diefill::engine {

/// A pair of spheres named by (grain id, sphere of the grain), the smaller first.
using SphereName = std::pair<std::uint64_t, std::size_t>;
using SpherePairs = std::multiset<std::pair<SphereName, SphereName>>;

inline std::pair<SphereName, SphereName> named(const Simulation& simulation, std::size_t i, std::size_t j) {
  const std::size_t per_grain = simulation.spheres().spheres_per_grain;
  const auto& ids = simulation.grains().id;
  const SphereName first{ids[i / per_grain], i % per_grain}, second{ids[j / per_grain], j % per_grain};
  return first < second ? std::pair{first, second} : std::pair{second, first};
}

/// Pairs that touched in the last step, as the engine has it.
inline SpherePairs found_pairs(const Simulation& simulation) {
  const auto& field = simulation.spheres();
  SpherePairs pairs;
  visit_touching_grain_pairs(simulation,
                             [&](const Block& block, std::size_t i, std::size_t p, const double*) {
                               std::size_t j = block.sphere(block.grain_pairs.pair[p].other);
                               j = field.owner(j) * field.spheres_per_grain + j % field.spheres_per_grain;
                               pairs.insert(named(simulation, i, j));
                             });
  return pairs;
}

/// Shortest of all periodic images of a distance.
inline Eigen::Vector3d nearest(const SimulationSettings& settings, Eigen::Vector3d between) {
  for (const std::size_t axis : {0U, 1U})
    if (settings.period[axis]) {
      double& x = between[static_cast<Eigen::Index>(axis)];
      x -= *settings.period[axis] * std::round(x / *settings.period[axis]);
    }
  return between;
}

/// Pairs that touch now, by looking at all there are.
inline SpherePairs all_touching_pairs(const Simulation& simulation) {
  const auto& field = simulation.spheres();
  const auto& settings = simulation.settings();
  const std::size_t per_grain = field.spheres_per_grain;
  SpherePairs pairs;
  for (std::size_t a = 0; a < field.grains; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Eigen::Vector3d centres =
          nearest(settings, simulation.grains().position[a] - simulation.grains().position[b]);
      if (centres.norm() > 2 * settings.shape().bounding_radius()) continue;
      for (std::size_t i = a * per_grain; i < (a + 1) * per_grain; ++i)
        for (std::size_t j = b * per_grain; j < (b + 1) * per_grain; ++j)
          if (nearest(settings, eigen(field.position(i) - field.position(j))).norm() <
              2 * settings.shape().sphere_radius)
            pairs.insert(named(simulation, i, j));
    }
  return pairs;
}

}  // namespace diefill::engine
