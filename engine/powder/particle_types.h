// Powders whose grains are not all alike: kinds of grains, which differ in size, shape or material, and the
// laws between their materials.
//
// A grain refers to its kind by a small number; mass, size and law follow from the table of kinds. A size
// distribution becomes a number of kinds (size_classes.h), so that laws between all pairs of kinds can be
// made once, before the run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/coarse_graining/force_scaling.h"
#include "engine/laws/law_parameters.h"
#include "engine/powder/grain_shape.h"

namespace diefill::engine {

/// Number of a grain's kind in the table of kinds.
using KindNumber = std::uint16_t;

/// What grains of one kind have in common.
struct ParticleType {
  GrainShape shape;
  std::string material;
};

/// A powder of several kinds. Kinds are as they are simulated; where forces are scaled, laws are those of the
/// original grains (coarse_graining/force_scaling.h).
struct GrainMix {
  /// Largest number of kinds: laws are made for all their pairs.
  static constexpr std::size_t kMostKinds = 256;

  std::vector<ParticleType> kinds;
  std::vector<laws::MaterialPairLaw> laws;  ///< between all materials of grains, and of grains with walls
  coarse_graining::ForceScaling scaling;    ///< as it stands: none
};

/// The kinds of a powder, one where all grains are alike.
class KindTable {
 public:
  /// Throws std::invalid_argument for no kinds or too many, a kind without spheres, mass or moment of
  /// inertia, or kinds that cannot be in one powder: their grains must be made of equal numbers of spheres,
  /// and all rotate or none.
  explicit KindTable(std::vector<ParticleType> kinds);

  std::size_t size() const { return kinds_.size(); }
  bool monodisperse() const { return kinds_.size() == 1; }
  const GrainShape& shape(KindNumber kind) const { return kinds_[kind].shape; }
  const std::string& material(KindNumber kind) const { return kinds_[kind].material; }

  /// Spheres of a grain of any kind.
  std::size_t spheres() const { return kinds_.front().shape.spheres(); }
  bool clumps() const { return spheres() > 1; }
  bool rotates() const { return kinds_.front().shape.rotates; }

  /// m, radii of the kinds' spheres.
  std::vector<double> sphere_radii() const;
  double smallest_sphere() const { return smallest_sphere_; }
  double largest_sphere() const { return largest_sphere_; }
  /// m, the largest GrainShape::bounding_radius().
  double largest_grain() const { return largest_grain_; }
  /// m, of a sphere's centre from its grain's, at most.
  double farthest_sphere() const { return farthest_sphere_; }
  /// m: over the length |q - q_0| by which a grain's quaternion changes when it turns, how far a sphere goes
  /// at most. One at distance r goes no farther than 2 r |q - q_0|.
  double way_per_turn() const { return 2 * farthest_sphere_; }

 private:
  std::vector<ParticleType> kinds_;
  double smallest_sphere_ = 0, largest_sphere_ = 0, largest_grain_ = 0, farthest_sphere_ = 0;
};

}  // namespace diefill::engine
