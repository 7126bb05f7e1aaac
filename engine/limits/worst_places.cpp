#include "engine/limits/worst_places.h"

#include <cmath>
#include <cstdio>

#include "engine/observe/grain_contacts.h"

namespace diefill::engine {

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

FastestGrain fastest_for_its_size(const Simulation& simulation) {
  const Grains& grains = simulation.grains();
  FastestGrain fastest;
  double most = 0;  // 1/s^2, squared speed over squared radius
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const double radius = simulation.shape_of(k).sphere_radius;
    const double squared = grains.velocity[k].squaredNorm() / (radius * radius);
    if (squared <= most) continue;
    most = squared;
    fastest = {k, grains.velocity[k].norm()};
  }
  return fastest;
}

DeepestPair deepest_pair(const Simulation& simulation) {
  DeepestPair deepest;
  visit_grain_contacts(simulation, [&](std::size_t first, std::size_t second, double overlap) {
    if (overlap > deepest.overlap) deepest = {first, second, overlap};
  });
  return deepest;
}

std::string grain_text(const Grains& grains, std::size_t grain) {
  const Eigen::Vector3d place = 1e3 * grains.position[grain];
  char text[120];
  std::snprintf(text, sizeof text, "grain %llu at (%.2f, %.2f, %.2f) mm",
                static_cast<unsigned long long>(grains.id[grain]), place[0], place[1], place[2]);
  return text;
}

}  // namespace diefill::engine
