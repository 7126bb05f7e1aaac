#include "engine/powder/sphere_field.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "engine/numerics/shared_ranges.h"

namespace diefill::engine {

void check_sphere_count(std::size_t spheres) {
  // The last number stands for none.
  constexpr std::size_t kMostSpheres = std::numeric_limits<std::uint32_t>::max() - 1;
  if (spheres > kMostSpheres)
    throw std::length_error(
        "the powder has " + std::to_string(spheres) + " spheres with those of periodic images, of at most " +
        std::to_string(kMostSpheres) + "; take larger grains, fewer spheres per grain or less powder");
}

void SphereField::reorder_motion(const std::vector<std::uint32_t>& order) {
  if (spheres_per_grain == 1) return;
  for (std::vector<Vector3>* vectors : {&velocity, &spin}) {
    std::vector<Vector3> reordered(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      if (order[k] < grains) reordered[k] = (*vectors)[order[k]];
    vectors->swap(reordered);
  }
}

void SphereField::set_poses(const std::vector<Eigen::Vector3d>& position,
                            const std::vector<Quaternion>& orientation) {
  position_ = position.data();
  orientation_ = orientation.data();
}

void SphereField::set_motions(const std::vector<Eigen::Vector3d>& velocities,
                              const std::vector<Eigen::Vector3d>& spins) {
  velocity_ = velocities.data();
  spin_ = spins.data();
}

void SphereField::cache_positions(ThreadPool& pool) {
  if (spheres_per_grain == 1) return;
  constexpr std::size_t kGrainsAtATime = 2048;
  placed_.resize(real());
  in_runs(grains, kGrainsAtATime, pool, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t grain = begin; grain < end; ++grain) {
      const Vector3 centre = grain_centre(grain);
      const Rotation to_laboratory = rotation_of(orientation(grain));
      for (std::size_t number = 0; number < spheres_per_grain; ++number)
        placed_[grain * spheres_per_grain + number] = centre + to_laboratory * offset(grain, number);
    }
  });
}

}  // namespace diefill::engine
