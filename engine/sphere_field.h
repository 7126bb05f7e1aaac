// The spheres of all grains and of their images at one instant: what contacts are computed from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/periodic_box.h"
#include "engine/vector3.h"

namespace diefill::engine {

/// How a grain moves, laboratory frame.
struct GrainMotion {
  Vector3 velocity;  ///< m/s, of the centre of mass
  Vector3 spin;      ///< rad/s, angular velocity
};

/// Spheres, grain after grain; those of images follow those of real grains in number, but are held nowhere:
/// they are where their owner is, and shifted. Velocities are those predicted for the end of the step (OP-3);
/// they are held once a grain, as a sphere's follows from its grain's.
struct SphereField {
  std::size_t spheres_per_grain = 1;
  std::size_t grains = 0;       ///< real ones; images follow
  std::vector<Vector3> placed;  ///< m, centres of composed grains' spheres; single spheres are their grains
  std::vector<GrainMotion> motion;  ///< of real grains
  std::vector<GrainImage> images;
  PeriodicBox box;                  ///< beyond whose borders images are seen
  std::vector<std::uint16_t> kind;  ///< of grains; empty where all are alike
  /// m, x, y and z of the first real sphere's centre, followed by those of the others.
  const double* coordinates = nullptr;
  const double* centres = nullptr;  ///< m, the same of real grains' centres of mass

  /// Motion follows its grains: entry k becomes the former entry order[k].
  /// Grains that have just been added have none yet.
  void reorder_motion(const std::vector<std::uint32_t>& order);
  /// Spheres are from now on where grains at `position` (m) are, or where `placed` has them if grains are
  /// composed. Whoever moves either array to another place has to say so again.
  void stand_at(const std::vector<Eigen::Vector3d>& position);

  /// Spheres of real grains.
  std::size_t real() const { return grains * spheres_per_grain; }
  /// Those of images as well.
  std::size_t size() const { return (grains + images.size()) * spheres_per_grain; }
  /// m, from a grain's owner to the grain: 0 unless it is an image.
  Vector3 shift(std::size_t grain) const {
    return grain < grains ? Vector3{} : box.shift(images[grain - grains]);
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
  /// m, centre of mass of real grain k.
  Vector3 grain_centre(std::size_t k) const {
    return {centres[3 * k], centres[3 * k + 1], centres[3 * k + 2]};
  }
  /// m, centre of sphere k.
  Vector3 position(std::size_t k) const {
    const double* at = coordinates + 3 * original(k);
    const Vector3 centre = {at[0], at[1], at[2]};
    return k < real() ? centre : centre + shift(k / spheres_per_grain);
  }
};

}  // namespace diefill::engine
