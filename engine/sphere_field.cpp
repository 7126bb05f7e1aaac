#include "engine/sphere_field.h"

#include <algorithm>

namespace diefill::engine {

void SphereField::reorder_motion(const std::vector<std::uint32_t>& order) {
  std::vector<SphereMotion> reordered(order.size() * spheres_per_grain);
  for (std::size_t k = 0; k < order.size(); ++k)
    if (order[k] < grains)
      std::copy_n(motion.begin() + static_cast<std::ptrdiff_t>(order[k] * spheres_per_grain),
                  spheres_per_grain, reordered.begin() + static_cast<std::ptrdiff_t>(k * spheres_per_grain));
  motion.swap(reordered);
}

void SphereField::stand_at(const std::vector<Eigen::Vector3d>& position) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double) && sizeof(Eigen::Vector3d) == sizeof(Vector3));
  if (spheres_per_grain > 1)
    coordinates = placed.empty() ? nullptr : &placed.front().x;
  else
    coordinates = position.empty() ? nullptr : position.front().data();
}

}  // namespace diefill::engine
