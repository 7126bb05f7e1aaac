#include "engine/contact/pair_laws.h"

#include <limits>
#include <stdexcept>

namespace diefill::engine {

namespace {

void refuse_rolling_clumps(const ParticleTypes& types, const laws::LawParameters& law) {
  if (law.rolling.own_spin_arm() != 0 && types.clumps())
    throw std::invalid_argument(
        "rolling friction against a grain's own spin is a law of single spheres; clumps interlock instead: "
        "take another rolling law or single spheres");
}

}  // namespace

laws::GeneralContactLaw law_between(const ParticleTypes& types, const ContactLaws& contact, ClassNumber i,
                                    ClassNumber j) {
  const SphereClass &one = types.classes()[i], &other = types.classes()[j];
  const auto& law = contact.between(types.material(one.type), types.material(other.type));
  refuse_rolling_clumps(types, law);
  return {law, contact.scaling,
          laws::PairProperties{one.radius, other.radius, types.shape(one.type).mass,
                               types.shape(other.type).mass}};
}

laws::GeneralContactLaw law_at_wall(const ParticleTypes& types, const ContactLaws& contact, ClassNumber own,
                                    const WallSurface& wall) {
  if (wall.mirror) return law_between(types, contact, own, own);
  const SphereClass& sphere = types.classes()[own];
  const std::string& material = types.material(sphere.type);
  const auto& parameters = contact.between(material, wall.material);
  refuse_rolling_clumps(types, parameters);
  laws::GeneralContactLaw law(parameters, contact.scaling,
                              laws::PairProperties{sphere.radius, wall.radius, types.shape(sphere.type).mass,
                                                   std::numeric_limits<double>::infinity()});
  if (law.range() > 0)
    throw std::invalid_argument("contact law between '" + material + "' and '" + wall.material +
                                "': walls attract only what touches them; give the wall a law without "
                                "attraction at a distance");
  return law;
}

ClassPairs::ClassPairs(const ParticleTypes& types, const ContactLaws& contact)
    : count_(static_cast<std::uint32_t>(types.classes().size())),
      law_(count_ * count_),
      reach_(law_.size()),
      reach_squared_(law_.size()) {
  for (std::uint32_t i = 0; i < count_; ++i)
    for (std::uint32_t j = i; j < count_; ++j) {
      const double radius = types.classes()[i].radius, other_radius = types.classes()[j].radius;
      law_[i * count_ + j] = law_[j * count_ + i] = static_cast<std::uint32_t>(laws_.size());
      laws_.push_back(law_between(types, contact, static_cast<ClassNumber>(i), static_cast<ClassNumber>(j)));
      reach_[i * count_ + j] = {radius + other_radius, radius};
      reach_[j * count_ + i] = {radius + other_radius, other_radius};
      const double reach = radius + other_radius + laws_.back().range();
      reach_squared_[i * count_ + j] = reach_squared_[j * count_ + i] = reach * reach;
      range_ = std::max(range_, laws_.back().range());
    }
}

}  // namespace diefill::engine
