// The spheres that a block's pairs are between, copied side by side: what a contact needs lies together, in
// records that one vector load takes in.
#pragma once

#include <vector>

#include "engine/look_ahead.h"
#include "engine/pair_table.h"
#include "engine/sphere_field.h"
#include "engine/transpose.h"

namespace diefill::engine {

/// Spheres by their number in the block last taken in.
class LocalSpheres {
 public:
  /// A centre (m), with one number to spare.
  struct alignas(32) Centre {
    double value[4];
  };

  const Centre& centre(LocalSphere k) const { return centres_[k]; }
  /// Velocity (m/s) and spin (rad/s) in numbers 0 to 5; the rest is 0.
  const Record& motion(LocalSphere k) const { return motion_[k]; }
  /// m, centre of sphere k.
  Vector3 position(LocalSphere k) const {
    const Centre& centre = centres_[k];
    return {centre.value[0], centre.value[1], centre.value[2]};
  }
  /// m/s, velocity of its centre.
  Vector3 velocity(LocalSphere k) const {
    const Record& motion = motion_[k];
    return {motion.value[0], motion.value[1], motion.value[2]};
  }
  /// rad/s, angular velocity of its grain.
  Vector3 spin(LocalSphere k) const {
    const Record& motion = motion_[k];
    return {motion.value[3], motion.value[4], motion.value[5]};
  }

  /// Takes in the block's own spheres and their partners as they are now.
  void take(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.own_spheres(), all = own + block.partners.size();
    if (centres_.size() < all) {
      centres_.resize(all);
      motion_.resize(all);
    }
    const std::size_t first = std::size_t{block.begin} * block.spheres_per_grain;
    constexpr std::size_t kAhead = 16;
    for (std::size_t k = 0; k < own; ++k) {
      look_ahead<1>(spheres.motion, first + k + kAhead);
      __builtin_prefetch(spheres.coordinates + 3 * std::min(first + k + kAhead, spheres.real() - 1));
      put(k, spheres, first + k);
    }
    const std::size_t real = spheres.real();
    for (std::size_t k = own; k < all; ++k) {
      const std::size_t partner = block.partners[k - own];
      if (partner < real)
        put(k, spheres, partner);
      else
        put_image(k, spheres, partner);
    }
  }

 private:
  void put(std::size_t k, const SphereField& spheres, std::size_t sphere) {
    static_assert(sizeof(SphereMotion) == 6 * sizeof(double));
    __builtin_memcpy(centres_[k].value, spheres.coordinates + 3 * sphere, sizeof(Vector3));
    __builtin_memcpy(motion_[k].value, &spheres.motion[sphere], sizeof(SphereMotion));
  }
  void put_image(std::size_t k, const SphereField& spheres, std::size_t sphere) {
    put(k, spheres, spheres.original(sphere));
    const Vector3 centre = spheres.position(sphere);
    __builtin_memcpy(centres_[k].value, &centre, sizeof centre);
  }

  std::vector<Centre> centres_;
  std::vector<Record> motion_;
};

}  // namespace diefill::engine
