#include "engine/contact/pair_laws.h"

#include <limits>
#include <stdexcept>

namespace diefill::engine {

namespace {

/// The parameters between two materials, once they have been found sensible.
const laws::LawParameters& checked_law(const GrainMix& mix, const std::string& a, const std::string& b) {
  const auto& law = laws::law_between(mix.laws, a, b);
  try {
    laws::require_sensible(law);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("contact law between '" + a + "' and '" + b + "': " + error.what());
  }
  return law;
}

}  // namespace

laws::GeneralContactLaw law_of_kinds(const KindTable& kinds, const GrainMix& mix, KindNumber i,
                                     KindNumber j) {
  const GrainShape &one = kinds.shape(i), &other = kinds.shape(j);
  return {checked_law(mix, kinds.material(i), kinds.material(j)), mix.scaling,
          laws::PairProperties{one.sphere_radius, other.sphere_radius, one.mass, other.mass}};
}

laws::GeneralContactLaw law_with_wall(const KindTable& kinds, const GrainMix& mix, KindNumber kind,
                                      const std::string& wall_material, double wall_radius) {
  const GrainShape& shape = kinds.shape(kind);
  laws::GeneralContactLaw law(checked_law(mix, kinds.material(kind), wall_material), mix.scaling,
                              laws::PairProperties{shape.sphere_radius, wall_radius, shape.mass,
                                                   std::numeric_limits<double>::infinity()});
  if (law.range() > 0)
    throw std::invalid_argument("contact law between '" + kinds.material(kind) + "' and '" + wall_material +
                                "': walls attract only what touches them; give the wall law no distant "
                                "attraction");
  return law;
}

KindPairs::KindPairs(const KindTable& kinds, const GrainMix& mix)
    : count_(static_cast<std::uint32_t>(kinds.size())),
      law_(kinds.size() * kinds.size()),
      reach_(law_.size()),
      reach_squared_(law_.size()) {
  for (std::uint32_t i = 0; i < count_; ++i)
    for (std::uint32_t j = i; j < count_; ++j) {
      const auto one = static_cast<KindNumber>(i), other = static_cast<KindNumber>(j);
      const double radius = kinds.shape(one).sphere_radius, other_radius = kinds.shape(other).sphere_radius;
      law_[i * count_ + j] = law_[j * count_ + i] = static_cast<std::uint32_t>(laws_.size());
      laws_.push_back(law_of_kinds(kinds, mix, one, other));
      reach_[i * count_ + j] = {radius + other_radius, radius};
      reach_[j * count_ + i] = {radius + other_radius, other_radius};
      const double reach = radius + other_radius + laws_.back().range();
      reach_squared_[i * count_ + j] = reach_squared_[j * count_ + i] = reach * reach;
      range_ = std::max(range_, laws_.back().range());
    }
}

}  // namespace diefill::engine
