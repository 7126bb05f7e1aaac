#include "engine/sphere_field.h"

namespace diefill::engine {

void SphereField::reorder_motion(const std::vector<std::uint32_t>& order) {
  std::vector<GrainMotion> reordered(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    if (order[k] < grains) reordered[k] = motion[order[k]];
  motion.swap(reordered);
}

void SphereField::stand_at(const std::vector<Eigen::Vector3d>& position) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double) && sizeof(Eigen::Vector3d) == sizeof(Vector3));
  centres = position.empty() ? nullptr : position.front().data();
  if (spheres_per_grain > 1)
    coordinates = placed.empty() ? nullptr : &placed.front().x;
  else
    coordinates = centres;
}

}  // namespace diefill::engine
