#include "engine/worst_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

namespace diefill::engine {

namespace {

using Cell = std::array<long, 3>;

Cell cell_of(Vector3 place, double size) {
  return {std::lround(place.x / size), std::lround(place.y / size), std::lround(place.z / size)};
}

/// Calls visit(other) for the spheres in the cell and around it.
template <class Visit>
void visit_around(const std::map<Cell, std::vector<std::size_t>>& cells, const Cell& cell,
                  const Visit& visit) {
  for (long x = -1; x <= 1; ++x)
    for (long y = -1; y <= 1; ++y)
      for (long z = -1; z <= 1; ++z) {
        const auto found = cells.find({cell[0] + x, cell[1] + y, cell[2] + z});
        if (found == cells.end()) continue;
        for (const std::size_t other : found->second) visit(other);
      }
}

}  // namespace

FastestGrain fastest_grain(const Grains& grains) {
  FastestGrain fastest;
  double squared = 0;
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (grains.velocity[k].squaredNorm() > squared) {
      squared = grains.velocity[k].squaredNorm();
      fastest.grain = k;
    }
  fastest.speed = std::sqrt(squared);
  return fastest;
}

DeepestPair deepest_pair(const Simulation& simulation) {
  const SphereField& spheres = simulation.spheres();
  const double reach = 2 * simulation.settings().shape.sphere_radius;
  const std::size_t count = spheres.grains * spheres.spheres_per_grain;
  std::map<Cell, std::vector<std::size_t>> cells;
  DeepestPair deepest;
  for (std::size_t k = 0; k < count; ++k) {
    const Cell cell = cell_of(spheres.position[k], reach);
    visit_around(cells, cell, [&](std::size_t other) {
      if (spheres.owner(k) == spheres.owner(other)) return;
      const double overlap = reach - length(spheres.position[k] - spheres.position[other]);
      if (overlap > deepest.overlap) deepest = {spheres.owner(other), spheres.owner(k), overlap};
    });
    cells[cell].push_back(k);
  }
  return deepest;
}

std::string grain_in_words(const Grains& grains, std::size_t grain) {
  const Eigen::Vector3d place = 1e3 * grains.position[grain];
  char text[120];
  std::snprintf(text, sizeof text, "grain %llu at (%.2f, %.2f, %.2f) mm",
                static_cast<unsigned long long>(grains.id[grain]), place[0], place[1], place[2]);
  return text;
}

}  // namespace diefill::engine
