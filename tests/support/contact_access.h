// Bierwisch's parameters of a simulation's contact laws, read and changed in place, and short ways of writing
// laws for tests.
#pragma once

#include <limits>

#include "engine/laws/bierwisch_law.h"
#include "engine/limits/time_step.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

/// The law between two materials of `settings`.
inline laws::LawParameters& law_in(SimulationSettings& settings, const std::string& a, const std::string& b) {
  return const_cast<laws::LawParameters&>(laws::law_between(settings.contact.pairs, a, b));
}

/// Bierwisch's parameters between two materials; what is assigned to them is the law from the end of the
/// expression on.
class ContactAccess : public ContactParameters {
 public:
  ContactAccess(SimulationSettings& settings, const std::string& other)
      : law_(law_in(settings, kPowderMaterial, other)),
        limit_(laws::as_bierwisch(law_).value().spring_limit) {
    static_cast<ContactParameters&>(*this) = laws::as_bierwisch(law_).value().parameters;
  }
  ContactAccess(const ContactAccess&) = delete;
  ~ContactAccess() { law_ = laws::bierwisch_law(*this, limit_); }
  ContactParameters* operator->() { return this; }
  ContactAccess& operator=(const ContactParameters& given) {
    static_cast<ContactParameters&>(*this) = given;
    return *this;
  }
  ContactAccess& operator=(const ContactAccess& given) {
    return *this = static_cast<const ContactParameters&>(given);
  }

 private:
  laws::LawParameters& law_;
  SpringLimit limit_;
};

inline ContactAccess grain_contact(SimulationSettings& settings) {
  return {settings, kPowderMaterial};
}
inline ContactAccess wall_contact(SimulationSettings& settings) {
  return {settings, kWallMaterial};
}
inline ContactParameters grain_contact(const SimulationSettings& settings) {
  return laws::as_bierwisch(laws::law_between(settings.contact.pairs, kPowderMaterial, kPowderMaterial))
      .value()
      .parameters;
}
inline ContactParameters wall_contact(const SimulationSettings& settings) {
  return laws::as_bierwisch(laws::law_between(settings.contact.pairs, kPowderMaterial, kWallMaterial))
      .value()
      .parameters;
}
inline SpringLimit spring_limit(const SimulationSettings& settings) {
  return laws::as_bierwisch(settings.contact.pairs.front().law).value().spring_limit;
}
inline void set_spring_limit(SimulationSettings& settings, SpringLimit limit) {
  for (auto& pair : settings.contact.pairs)
    pair.law = laws::bierwisch_law(laws::as_bierwisch(pair.law).value().parameters, limit);
}

/// Laws of one powder and its walls.
struct GeneralContact {
  laws::LawParameters grains, walls;
  coarse_graining::ForceScaling scaling = {};

  operator ContactLaws() const { return one_powder(grains, walls, scaling); }  // NOLINT: short in tests
};

// Limits of one type of grains.

inline double impact_overlap(const GrainShape& shape, const ContactParameters& contact, double speed) {
  return impact_overlap(shape, laws::bierwisch_law(contact), speed);
}
inline double critical_time_step(const GrainShape& shape, const ContactParameters& contact, double speed) {
  return critical_time_step(shape, laws::bierwisch_law(contact), speed);
}
inline double critical_time_step_at_overlap(const GrainShape& shape, const ContactParameters& contact,
                                            double overlap) {
  return critical_time_step_at_overlap(shape, laws::bierwisch_law(contact), overlap);
}
inline double impact_overlap(const GrainShape& shape, const GeneralContact& contact, double speed) {
  return impact_overlap(ParticleTypes({{shape}}), contact, 0, 0, speed);
}
inline double critical_time_step(const GrainShape& shape, const GeneralContact& contact, double speed) {
  return critical_time_step(ParticleTypes({{shape}}), contact, {{}}, speed);
}
inline double critical_time_step_at_overlap(const GrainShape& shape, const GeneralContact& contact,
                                            double overlap) {
  return critical_time_step_at_overlap(ParticleTypes({{shape}}), contact, overlap,
                                       std::numeric_limits<double>::infinity());
}
inline double pinch_time_step(const GrainShape& shape, const GeneralContact& contact, double wall_radius,
                              double wall_spacing, double overlap) {
  return pinch_time_step(ParticleTypes({{shape}}), contact, 0, {kWallMaterial, wall_radius, false},
                         wall_spacing, overlap);
}
inline double pinch_time_step(const GrainShape& shape, const ContactParameters& contact, double wall_radius,
                              double wall_spacing, double overlap) {
  const auto law = laws::bierwisch_law(contact);
  return pinch_time_step(shape, GeneralContact{law, law}, wall_radius, wall_spacing, overlap);
}

}  // namespace diefill::engine
