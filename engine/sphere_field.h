// The spheres of all grains and of their images at one instant: what contacts are computed from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/periodic_box.h"
#include "engine/vector3.h"

namespace diefill::engine {

/// How a sphere moves, laboratory frame.
struct SphereMotion {
  Vector3 velocity;  ///< m/s, of the centre
  Vector3 spin;      ///< rad/s, angular velocity of its grain
};

/// Spheres, grain after grain; those of images follow those of real grains. Velocities are those predicted
/// for the end of the step (OP-3). Distances are tested for many more pairs than touch, so positions lie by
/// themselves.
struct SphereField {
  std::size_t spheres_per_grain = 1;
  std::size_t grains = 0;         ///< real ones; images follow
  std::vector<Vector3> position;  ///< m, centres
  std::vector<SphereMotion> motion;
  std::vector<GrainImage> images;
  std::vector<std::uint16_t> kind;  ///< of grains and images; empty where all are alike

  /// Velocities and spins of real grains follow their grains: entry k becomes the former entry order[k].
  /// Grains that have just been added have none yet.
  void reorder_motion(const std::vector<std::uint32_t>& order);

  std::size_t size() const { return position.size(); }
  /// m, from a grain's owner to the grain: 0 unless it is an image.
  Vector3 shift(std::size_t grain) const {
    return grain < grains ? Vector3{} : plain(images[grain - grains].shift);
  }
  /// Real grain that sphere k belongs to.
  std::size_t owner(std::size_t k) const {
    const std::size_t grain = k / spheres_per_grain;
    return grain < grains ? grain : images[grain - grains].owner;
  }
};

}  // namespace diefill::engine
