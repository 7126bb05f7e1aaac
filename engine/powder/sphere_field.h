// The spheres of all grains and of their images at one instant: what contacts are computed from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/vector3.h"
#include "engine/powder/periodic_box.h"
#include "engine/powder/rigid_motion.h"

namespace diefill::engine {

class ThreadPool;

/// How a grain moves, laboratory frame.
struct GrainMotion {
  Vector3 velocity;  ///< m/s, of the centre of mass
  Vector3 spin;      ///< rad/s, angular velocity
};

/// Spheres, grain after grain; those of images follow those of real grains in number, but are held nowhere:
/// they are where their owner is, and shifted. Velocities are those predicted for the end of the step (OP-3):
/// single spheres have them in the grains' own arrays while contacts are computed.
/// A clumped grain's spheres are where its pose has them, and move as it does: neither is held, as a grain
/// takes less memory than its spheres.
struct SphereField {
  std::size_t spheres_per_grain = 1;
  std::size_t grains = 0;         ///< real ones; images follow
  std::vector<Vector3> velocity;  ///< m/s, of clumped real grains' centres of mass
  std::vector<Vector3> spin;      ///< rad/s, of clumped real grains, laboratory frame
  std::vector<GrainImage> images;
  PeriodicBox box;                            ///< beyond whose borders images are seen
  std::vector<std::uint16_t> kind;            ///< particle types of grains; empty where there is one
  std::vector<std::vector<Vector3>> offsets;  ///< m, of the spheres of each type, body frame
  /// Where a type has fewer spheres than others, numbers are left over.
  bool equal_counts = true;
  std::vector<std::size_t> counts;          ///< spheres of each type
  std::vector<std::uint16_t> sphere_class;  ///< type after type, spheres_per_grain each

  /// Velocities and spins of clumped grains follow them: entry k becomes the former entry order[k]. Grains
  /// that have just been added have none yet.
  void reorder_motion(const std::vector<std::uint32_t>& order);
  /// Sets the arrays that poses are read from: `position` (m) and `orientation` (none for single spheres). To
  /// be called again when either array moves in memory.
  void set_poses(const std::vector<Eigen::Vector3d>& position, const std::vector<Quaternion>& orientation);
  /// Sets the arrays that motions of single spheres are read from: `velocities` (m/s) and `spins` (rad/s). As
  /// above.
  void set_motions(const std::vector<Eigen::Vector3d>& velocities, const std::vector<Eigen::Vector3d>& spins);
  /// Caches the present positions of clumped grains' spheres, for many queries at one instant; clears the
  /// cache.
  void cache_positions(ThreadPool& pool);
  void clear_cached_positions() { placed_.clear(); }

  /// Numbers of spheres of real grains.
  std::size_t real() const { return grains * spheres_per_grain; }
  /// Those of images as well.
  std::size_t size() const { return (grains + images.size()) * spheres_per_grain; }
  /// m, from a grain's owner to the grain: 0 unless it is an image.
  Vector3 shift(std::size_t grain) const {
    return grain < grains ? Vector3{} : box.shift(images[grain - grains]);
  }
  /// Type of a real grain.
  std::size_t type_of(std::size_t grain) const { return kind.empty() ? 0 : kind[grain]; }
  /// Whether there is a sphere of number k.
  bool exists(std::size_t k) const {
    return equal_counts || k % spheres_per_grain < counts[type_of(owner(k))];
  }
  /// Class of sphere k (ParticleTypes::classes()).
  std::uint16_t class_of(std::size_t k) const {
    return sphere_class[type_of(owner(k)) * spheres_per_grain + k % spheres_per_grain];
  }
  /// Real grain that sphere k belongs to.
  std::size_t owner(std::size_t k) const {
    const std::size_t grain = k / spheres_per_grain;
    return grain < grains ? grain : images[grain - grains].owner;
  }
  /// The real sphere that sphere k is or is an image of.
  std::size_t original(std::size_t k) const {
    return k < real() ? k : owner(k) * spheres_per_grain + k % spheres_per_grain;
  }
  /// Of real grain k.
  GrainMotion motion(std::size_t k) const {
    if (spheres_per_grain == 1) return {plain(velocity_[k]), plain(spin_[k])};
    return {velocity[k], spin[k]};
  }
  /// Where the numbers of a real single sphere lie: centre (m), velocity (m/s) and spin (rad/s), three each.
  /// Those of the next sphere follow.
  struct Single {
    const double *centre, *velocity, *spin;
  };
  Single single(std::size_t k) const { return {position_[k].data(), velocity_[k].data(), spin_[k].data()}; }
  /// Of clumped real grain k.
  void set_motion(std::size_t k, const GrainMotion& motion) {
    velocity[k] = motion.velocity;
    spin[k] = motion.spin;
  }
  /// m, centre of mass of real grain k.
  Vector3 grain_centre(std::size_t k) const { return plain(position_[k]); }
  /// Body to laboratory, of clumped real grain k.
  PlainQuaternion orientation(std::size_t k) const { return plain(orientation_[k]); }
  /// Prefetches what will be read of real grain k.
  /// Always inlined: prefetch.h gives the reason.
  [[gnu::always_inline]] void fetch(std::size_t k) const {
    __builtin_prefetch(position_ + k);
    if (spheres_per_grain == 1) {
      __builtin_prefetch(velocity_ + k);
      __builtin_prefetch(spin_ + k);
      return;
    }
    __builtin_prefetch(velocity.data() + k);
    __builtin_prefetch(spin.data() + k);
    __builtin_prefetch(orientation_ + k);
  }
  /// m, of sphere `number` of real grain k in its frame.
  const Vector3& offset(std::size_t k, std::size_t number) const { return offsets[type_of(k)][number]; }
  /// m, centre of sphere k.
  Vector3 position(std::size_t k) const {
    const Vector3 centre = position_of_real(original(k));
    return k < real() ? centre : centre + shift(k / spheres_per_grain);
  }

 private:
  Vector3 position_of_real(std::size_t k) const {
    if (spheres_per_grain == 1) return grain_centre(k);
    if (!placed_.empty()) return placed_[k];
    const std::size_t grain = k / spheres_per_grain;
    return grain_centre(grain) + rotation_of(orientation(grain)) * offset(grain, k % spheres_per_grain);
  }

  const Eigen::Vector3d* position_ = nullptr;
  const Quaternion* orientation_ = nullptr;
  const Eigen::Vector3d *velocity_ = nullptr, *spin_ = nullptr;
  std::vector<Vector3> placed_;
};

/// Throws std::length_error for more spheres, those of images among them, than can be numbered in the tables
/// of pairs, which have 32 bits for a number.
void check_sphere_count(std::size_t spheres);

}  // namespace diefill::engine
