// The spheres that a block's pairs are between, and the motion of their grains, copied side by side: what a
// contact needs lies together, in records that one vector load takes in.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/look_ahead.h"
#include "engine/pair_table.h"
#include "engine/sphere_field.h"
#include "engine/transpose.h"

namespace diefill::engine {

/// Spheres by their number in the block last taken in, grains by the number of their sum there
/// (Block::slot_of): single spheres and their grains have the same.
class LocalSpheres {
 public:
  /// A centre (m), with one number to spare.
  struct alignas(32) Centre {
    double value[4];
  };

  const Centre& centre(LocalSphere k) const { return centres_[k]; }
  /// m, centre of sphere k.
  Vector3 position(LocalSphere k) const {
    const Centre& centre = centres_[k];
    return {centre.value[0], centre.value[1], centre.value[2]};
  }
  /// Of a grain: velocity (m/s) and spin (rad/s) in numbers 0 to 5; the rest is 0. The velocity is that of a
  /// single sphere's centre. Of a composed grain it is what the rigid grain would have at the block's
  /// reference point, so that it is the same for all of its spheres.
  const Record& motion(std::size_t slot) const { return motion_[slot]; }
  /// m/s, as in motion().
  Vector3 velocity(std::size_t slot) const {
    const Record& motion = motion_[slot];
    return {motion.value[0], motion.value[1], motion.value[2]};
  }
  /// rad/s, angular velocity of a grain.
  Vector3 spin(std::size_t slot) const {
    const Record& motion = motion_[slot];
    return {motion.value[3], motion.value[4], motion.value[5]};
  }

  /// Takes in the block's own spheres and their partners as they are now.
  void take(const Block& block, const SphereField& spheres) {
    take_centres(block, spheres);
    if (spheres.spheres_per_grain == 1)
      take_motion(block, spheres);
    else
      take_motion_about_reference(block, spheres);
  }

 private:
  static constexpr std::size_t kAhead = 16;

  void take_centres(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.own_spheres(), partners = block.partners.size();
    if (centres_.size() < own + partners) centres_.resize(own + partners);
    const std::size_t first = std::size_t{block.begin} * block.spheres_per_grain, real = spheres.real();
    for (std::size_t k = 0; k < own; ++k) {
      __builtin_prefetch(spheres.coordinates + 3 * std::min(first + k + kAhead, real - 1));
      put_centre(k, spheres.coordinates + 3 * (first + k));
    }
    for (std::size_t k = 0; k < partners; ++k) {
      const std::size_t sphere = block.partners[k];
      if (sphere < real) {
        put_centre(own + k, spheres.coordinates + 3 * sphere);
      } else {
        const Vector3 centre = spheres.position(sphere);
        put_centre(own + k, &centre.x);
      }
    }
  }

  /// Grains are their spheres.
  void take_motion(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.own_spheres(), partners = block.partners.size();
    if (motion_.size() < own + partners) motion_.resize(own + partners);
    for (std::size_t k = 0; k < own; ++k) {
      look_ahead<1>(spheres.motion, block.begin + k + kAhead);
      put_motion(k, spheres.motion[block.begin + k]);
    }
    for (std::size_t k = 0; k < partners; ++k)
      put_motion(own + k, spheres.motion[spheres.original(block.partners[k])]);
  }

  void take_motion_about_reference(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.grains();
    if (motion_.size() < own + block.seen.size()) motion_.resize(own + block.seen.size());
    const Vector3 reference = plain(block.reference);
    const auto put_moved = [&](std::size_t slot, const GrainMotion& motion, const Vector3& centre) {
      put_motion(slot, {motion.velocity + cross(motion.spin, reference - centre), motion.spin});
    };
    for (std::size_t k = 0; k < own; ++k) {
      look_ahead<1>(spheres.motion, block.begin + k + kAhead);
      put_moved(k, spheres.motion[block.begin + k], spheres.grain_centre(block.begin + k));
    }
    for (std::size_t k = 0; k < block.seen.size(); ++k) {
      const std::size_t grain = block.foreign[k];
      put_moved(own + k, spheres.motion[grain], spheres.grain_centre(grain) + spheres.shift(block.seen[k]));
    }
  }

  void put_centre(std::size_t k, const double* centre) {
    __builtin_memcpy(centres_[k].value, centre, sizeof(Vector3));
  }
  void put_motion(std::size_t slot, const GrainMotion& motion) {
    static_assert(sizeof(GrainMotion) == 6 * sizeof(double));
    __builtin_memcpy(motion_[slot].value, &motion, sizeof motion);
  }

  std::vector<Centre> centres_;
  std::vector<Record> motion_;
};

}  // namespace diefill::engine
