// What the grains of a simulation are: particle types, which differ in size, shape or material, and the
// contact laws between their materials and those of the walls. The one description of powder and contact.
//
// A grain refers to its type by a small number; mass, size and law follow from tables. A size distribution
// becomes a number of types (size_classes.h), so that laws between all pairs can be made once, before the
// run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/coarse_graining/force_scaling.h"
#include "engine/laws/law_parameters.h"
#include "engine/powder/grain_shape.h"
#include "engine/powder/materials.h"

namespace diefill::engine {

/// Number of a grain's type.
using TypeNumber = std::uint16_t;

/// What grains of one type have in common.
struct ParticleType {
  GrainShape shape;
  std::string material = kPowderMaterial;
};

/// Contact of everything with everything. Where forces are scaled, laws are those of the original grains and
/// types are as they are simulated (coarse_graining/force_scaling.h); moments of inertia then are those with
/// which torques, energy and angular momentum balance.
struct ContactLaws {
  std::vector<laws::MaterialPairLaw> pairs;  ///< between materials of grains, and of grains with walls
  coarse_graining::ForceScaling scaling;     ///< as it stands: none

  /// The law of two materials. Throws std::invalid_argument naming both where there is none, or where its
  /// parts do not go together.
  const laws::LawParameters& between(const std::string& a, const std::string& b) const;
};

/// Contact of one powder and walls of one material.
ContactLaws one_powder(const laws::LawParameters& grains, const laws::LawParameters& walls,
                       const coarse_graining::ForceScaling& scaling = {});

/// Number of a class of spheres: those of one type and radius.
using ClassNumber = std::uint16_t;

/// Spheres that meet others by one law: of one radius, on grains of one type.
struct SphereClass {
  TypeNumber type = 0;
  double radius = 0;  ///< m
};

/// The types of a simulation, and the classes of their spheres, type after type. Types of equal spheres have
/// one class each.
class ParticleTypes {
 public:
  /// Largest number of types and of classes: laws are made for all their pairs.
  static constexpr std::size_t kMaxTypes = 256, kMaxClasses = 1024;

  /// Throws std::invalid_argument for no types or too many, or a type without spheres, mass or moment of
  /// inertia. Where some types rotate and others do not, the others get moments of inertia that nothing
  /// turns.
  explicit ParticleTypes(std::vector<ParticleType> types);

  std::size_t size() const { return types_.size(); }
  bool monodisperse() const { return types_.size() == 1; }
  const GrainShape& shape(TypeNumber type) const { return types_[type].shape; }
  const std::string& material(TypeNumber type) const { return types_[type].material; }

  const std::vector<SphereClass>& classes() const { return classes_; }
  /// Of sphere `number` of a grain of `type`.
  ClassNumber class_of(TypeNumber type, std::size_t number) const {
    return class_of_sphere_[type * spheres_ + number];
  }

  /// Spheres of a grain, at most: every grain has numbers for so many.
  std::size_t spheres() const { return spheres_; }
  bool clumps() const { return spheres_ > 1; }
  /// Whether all grains have as many spheres.
  bool equal_counts() const { return equal_counts_; }
  bool rotates() const { return types_.front().shape.rotates; }
  /// Whether torques turn grains of `type`.
  bool turns(TypeNumber type) const { return turns_[type]; }

  /// m, radii of the classes.
  std::vector<double> sphere_radii() const;
  double smallest_sphere() const { return smallest_sphere_; }
  double largest_sphere() const { return largest_sphere_; }
  /// m, the largest GrainShape::bounding_radius().
  double largest_grain() const { return largest_grain_; }
  /// m, of a sphere's centre from its grain's, at most.
  double farthest_sphere() const { return farthest_sphere_; }
  /// m: over the length |q - q_0| by which a grain's quaternion changes when it turns, how far a sphere goes
  /// at most. One at distance r goes no farther than 2 r |q - q_0|.
  double displacement_per_turn() const { return 2 * farthest_sphere_; }

 private:
  void include(TypeNumber type);
  void make_unturnable();

  std::vector<ParticleType> types_;
  std::vector<SphereClass> classes_;
  std::vector<ClassNumber> class_of_sphere_;
  std::size_t spheres_ = 0;
  bool equal_counts_ = true;
  std::vector<bool> turns_;
  double smallest_sphere_ = 0, largest_sphere_ = 0, largest_grain_ = 0, farthest_sphere_ = 0;
};

/// The types as they move: where forces are scaled, with the moments of inertia that torques balance with.
ParticleTypes moving_types(std::vector<ParticleType> types, const coarse_graining::ForceScaling& scaling);

}  // namespace diefill::engine
