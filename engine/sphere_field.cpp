#include "engine/sphere_field.h"

namespace diefill::engine {

void SphereField::reorder_motion(const std::vector<std::uint32_t>& order) {
  const std::size_t known = spin.size();
  std::vector<Vector3> new_spin(order.size()), new_velocity(order.size() * spheres_per_grain);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (order[k] >= known) continue;
    new_spin[k] = spin[order[k]];
    for (std::size_t s = 0; s < spheres_per_grain; ++s)
      new_velocity[k * spheres_per_grain + s] = velocity[order[k] * spheres_per_grain + s];
  }
  spin.swap(new_spin);
  velocity.swap(new_velocity);
}

}  // namespace diefill::engine
