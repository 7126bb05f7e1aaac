#include "engine/powder/particle_types.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace diefill::engine {

namespace {

void require(bool holds, const std::string& reason) {
  if (!holds) throw std::invalid_argument(reason);
}

void check_kind(const GrainShape& shape, const GrainShape& first, std::size_t number) {
  const std::string kind = "kind " + std::to_string(number) + " of the grains ";
  require(!shape.sphere_offsets.empty(), kind + "has no spheres");
  require(shape.sphere_radius > 0 && shape.mass > 0, kind + "has no size or no mass");
  require(!shape.rotates || shape.inertia.minCoeff() > 0, kind + "has no moment of inertia");
  require(shape.spheres() == first.spheres(),
          kind + "is made of " + std::to_string(shape.spheres()) + " spheres and the first one of " +
              std::to_string(first.spheres()) +
              ": grains of one powder must be made of equal numbers of spheres; choose one grain model for "
              "all");
  require(shape.rotates == first.rotates,
          kind +
              (shape.rotates ? "rotates and the first one does not" : "does not rotate but the first one") +
              ": choose one grain model for all");
}

}  // namespace

KindTable::KindTable(std::vector<ParticleType> kinds) : kinds_(std::move(kinds)) {
  require(!kinds_.empty(), "a powder needs at least one kind of grains");
  require(kinds_.size() <= GrainMix::kMostKinds,
          "a powder of " + std::to_string(kinds_.size()) + " kinds of grains: at most " +
              std::to_string(GrainMix::kMostKinds) + " are allowed; take fewer size classes");
  smallest_sphere_ = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    const GrainShape& shape = kinds_[k].shape;
    check_kind(shape, kinds_.front().shape, k);
    smallest_sphere_ = std::min(smallest_sphere_, shape.sphere_radius);
    largest_sphere_ = std::max(largest_sphere_, shape.sphere_radius);
    largest_grain_ = std::max(largest_grain_, shape.bounding_radius());
    farthest_sphere_ = std::max(farthest_sphere_, shape.bounding_radius() - shape.sphere_radius);
  }
}

std::vector<double> KindTable::sphere_radii() const {
  std::vector<double> radii;
  for (const auto& kind : kinds_) radii.push_back(kind.shape.sphere_radius);
  return radii;
}

}  // namespace diefill::engine
