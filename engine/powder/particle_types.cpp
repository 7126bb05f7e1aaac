#include "engine/powder/particle_types.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace diefill::engine {

namespace {

void require(bool holds, const std::string& reason) {
  if (!holds) throw std::invalid_argument(reason);
}

void check_type(const GrainShape& shape, std::size_t number) {
  const std::string type = "particle type " + std::to_string(number) + " ";
  require(!shape.sphere_offsets.empty(), type + "has no spheres");
  require(shape.sphere_radii.empty() || shape.sphere_radii.size() == shape.spheres(),
          type + "has " + std::to_string(shape.sphere_radii.size()) + " radii for " +
              std::to_string(shape.spheres()) + " spheres; give one for each");
  require(shape.sphere_radius > 0 && shape.mass > 0, type + "has no size or no mass");
  require(!shape.rotates || shape.inertia.minCoeff() > 0, type + "has no moment of inertia");
}

}  // namespace

const laws::LawParameters& ContactLaws::between(const std::string& a, const std::string& b) const {
  const auto& law = laws::law_between(pairs, a, b);
  try {
    laws::require_sensible(law);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("contact law between '" + a + "' and '" + b + "': " + error.what());
  }
  return law;
}

ContactLaws one_powder(const laws::LawParameters& grains, const laws::LawParameters& walls,
                       const coarse_graining::ForceScaling& scaling) {
  return {{{kPowderMaterial, kPowderMaterial, grains}, {kPowderMaterial, kWallMaterial, walls}}, scaling};
}

ParticleTypes::ParticleTypes(std::vector<ParticleType> types) : types_(std::move(types)) {
  require(!types_.empty(), "a powder needs at least one particle type");
  require(types_.size() <= kMaxTypes, "a powder of " + std::to_string(types_.size()) +
                                          " particle types: at most " + std::to_string(kMaxTypes) +
                                          " are allowed; take fewer size classes");
  for (std::size_t k = 0; k < types_.size(); ++k) {
    check_type(types_[k].shape, k);
    spheres_ = std::max(spheres_, types_[k].shape.spheres());
  }
  class_of_sphere_.resize(types_.size() * spheres_);
  smallest_sphere_ = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < types_.size(); ++k) include(static_cast<TypeNumber>(k));
  require(classes_.size() <= kMaxClasses,
          "grains of " + std::to_string(classes_.size()) + " types and sphere radii: at most " +
              std::to_string(kMaxClasses) + " are allowed; take fewer types or clumps of equal spheres");
  make_unturnable();
}

/// Numbers the classes of a type's spheres; numbers that it has no sphere for get its first one.
void ParticleTypes::include(TypeNumber type) {
  const GrainShape& shape = types_[type].shape;
  const std::size_t first = classes_.size();
  equal_counts_ = equal_counts_ && shape.spheres() == spheres_;
  for (std::size_t k = 0; k < spheres_; ++k) {
    const double radius = shape.radius_of(k < shape.spheres() ? k : 0);
    auto found = std::find_if(classes_.begin() + static_cast<std::ptrdiff_t>(first), classes_.end(),
                              [&](const SphereClass& one) { return one.radius == radius; });
    if (found == classes_.end()) found = classes_.insert(classes_.end(), {type, radius});
    class_of_sphere_[type * spheres_ + k] = static_cast<ClassNumber>(found - classes_.begin());
    smallest_sphere_ = std::min(smallest_sphere_, radius);
    largest_sphere_ = std::max(largest_sphere_, radius);
  }
  largest_grain_ = std::max(largest_grain_, shape.bounding_radius());
  for (const auto& offset : shape.sphere_offsets)
    farthest_sphere_ = std::max(farthest_sphere_, offset.norm());
}

/// Where some types rotate, the others do so, too, but for nothing that could turn them.
void ParticleTypes::make_unturnable() {
  constexpr double kNothingTurnsIt = 1e30;
  for (const ParticleType& type : types_) turns_.push_back(type.shape.rotates);
  const auto rotates = [](const ParticleType& type) { return type.shape.rotates; };
  if (std::none_of(types_.begin(), types_.end(), rotates)) return;
  for (ParticleType& type : types_) {
    if (type.shape.rotates) continue;
    type.shape.rotates = true;
    type.shape.inertia *= kNothingTurnsIt;
  }
}

std::vector<double> ParticleTypes::sphere_radii() const {
  std::vector<double> radii;
  for (const auto& one : classes_) radii.push_back(one.radius);
  return radii;
}

ParticleTypes moving_types(std::vector<ParticleType> types, const coarse_graining::ForceScaling& scaling) {
  for (auto& type : types) type.shape.inertia /= scaling.torque_factor();
  return ParticleTypes(std::move(types));
}

}  // namespace diefill::engine
