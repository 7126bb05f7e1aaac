#include "engine/limits/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/limits/law_probe.h"
#include "engine/limits/pinching_contacts.h"
#include "engine/limits/stable_step.h"

namespace diefill::engine {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Overlap of a grain held by others over that of an impact at the highest speed.
constexpr double kHeldOverlap = 0.1;

/// A sphere that meets another, or a wall.
class MeetingPair {
 public:
  MeetingPair(const ParticleTypes& types, const ContactLaws& contact, ClassNumber i, ClassNumber j)
      : MeetingPair(law_between(types, contact, i, j), shape_of(types, i), shape_of(types, j),
                    std::min(types.classes()[i].radius, types.classes()[j].radius)) {}
  MeetingPair(const ParticleTypes& types, const ContactLaws& contact, ClassNumber i, const WallSurface& wall)
      : probe_(law_at_wall(types, contact, i, wall)),
        radius_(types.classes()[i].radius),
        mass_(shape_of(types, i).mass),
        meeting_(masses_of(shape_of(types, i))),
        packed_(meeting_) {}

  /// m, of the smaller sphere.
  double radius() const { return radius_; }
  /// m, of a head-on collision at `speed` (m/s).
  double overlap_of_impact(double speed) const {
    return probe_.overlap_of_energy(0.5 * mass_ * speed * speed + probe_.energy_of_approach(), radius_);
  }
  /// s, of one contact at `overlap` (m), on the reduced masses.
  double shortest_at(double overlap) const { return step_limit(probe_.springs(overlap), meeting_, 1); }
  /// s, the same of a grain that others hold, on half of the smaller one.
  double shortest_held_at(double overlap) const { return step_limit(probe_.springs(overlap), packed_, 1); }
  /// s, the longest stable step of one contact that stays at `overlap` (m).
  double lasting_at(double overlap) const {
    const ContactSprings springs = probe_.springs(overlap);
    return std::min(stable_step(meeting_.normal, springs.normal, springs.damping),
                    stable_step(meeting_.sliding, springs.tangential, springs.sliding_damping));
  }
  /// s, of an impact at `speed` (m/s) and of a packing.
  double shortest(double speed) const {
    const double overlap = overlap_of_impact(speed);
    // Many contacts share what damping there is: their springs alone.
    ContactSprings packed = probe_.springs(kHeldOverlap * overlap);
    packed.damping = packed.sliding_damping = 0;
    return std::min(
        {shortest_at(overlap), step_limit(packed, packed_, kContactsPerGrain), crossing_time(probe_, mass_)});
  }

 private:
  MeetingPair(const laws::GeneralContactLaw& law, const GrainShape& one, const GrainShape& other,
              double smaller_radius)
      : probe_(law),
        radius_(smaller_radius),
        mass_(laws::PairProperties::reduced(one.mass, other.mass)),
        meeting_(reduced(masses_of(one), masses_of(other))),
        packed_(half_of_smaller(masses_of(one), masses_of(other))) {}

  static const GrainShape& shape_of(const ParticleTypes& types, ClassNumber sphere_class) {
    return types.shape(types.classes()[sphere_class].type);
  }

  LawProbe probe_;
  double radius_, mass_;
  ContactMasses meeting_, packed_;
};

/// Calls visit(pair) for every pair of classes.
template <class Visit>
void visit_pairs(const ParticleTypes& types, const ContactLaws& contact, const Visit& visit) {
  for (std::size_t i = 0; i < types.classes().size(); ++i)
    for (std::size_t j = i; j < types.classes().size(); ++j)
      visit(MeetingPair(types, contact, static_cast<ClassNumber>(i), static_cast<ClassNumber>(j)));
}

/// The same, and for every class at every wall.
template <class Visit>
void visit_pairs_and_walls(const ParticleTypes& types, const ContactLaws& contact,
                           const std::vector<WallSurface>& walls, const Visit& visit) {
  visit_pairs(types, contact, visit);
  for (std::size_t own = 0; own < types.classes().size(); ++own)
    for (const auto& wall : walls) visit(MeetingPair(types, contact, static_cast<ClassNumber>(own), wall));
}

ContactLaws among_themselves(const laws::LawParameters& law) {
  return {{{kPowderMaterial, kPowderMaterial, law}}, {}};
}

}  // namespace

double mobility(const GrainShape& shape) {
  if (!shape.rotates) return 1;
  double lever = 0;
  for (const auto& offset : shape.sphere_offsets) lever = std::max(lever, offset.norm());
  return 1 + lever * lever * shape.mass / shape.inertia.minCoeff();
}

double impact_overlap(const ParticleTypes& types, const ContactLaws& contact, ClassNumber i, ClassNumber j,
                      double impact_speed) {
  return MeetingPair(types, contact, i, j).overlap_of_impact(impact_speed);
}

double critical_time_step(const ParticleTypes& types, const ContactLaws& contact,
                          const std::vector<WallSurface>& walls, double impact_speed) {
  double critical = kNoLimit;
  visit_pairs_and_walls(types, contact, walls, [&](const MeetingPair& pair) {
    critical = std::min(critical, pair.shortest(impact_speed));
  });
  return critical;
}

double lasting_contact_time_step(const ParticleTypes& types, const ContactLaws& contact,
                                 const std::vector<WallSurface>& walls, double impact_speed) {
  double longest = kNoLimit;
  visit_pairs_and_walls(types, contact, walls, [&](const MeetingPair& pair) {
    longest = std::min(longest, pair.lasting_at(kHeldOverlap * pair.overlap_of_impact(impact_speed)));
  });
  return longest;
}

double critical_time_step_at_overlap(const ParticleTypes& types, const ContactLaws& contact, double overlap,
                                     double overlap_over_radius) {
  double critical = kNoLimit;
  visit_pairs(types, contact, [&](const MeetingPair& pair) {
    critical =
        std::min(critical, pair.shortest_held_at(std::min(overlap, overlap_over_radius * pair.radius())));
  });
  return critical;
}

double collision_time_step(const ParticleTypes& types, const ContactLaws& contact, double impact_speed) {
  double critical = kNoLimit;
  visit_pairs(types, contact, [&](const MeetingPair& pair) {
    critical = std::min(critical, pair.shortest_at(pair.overlap_of_impact(impact_speed)));
  });
  return critical;
}

double pinch_time_step(const ParticleTypes& types, const ContactLaws& contact, ClassNumber own,
                       const WallSurface& wall, double wall_spacing, double overlap) {
  const GrainShape& shape = types.shape(types.classes()[own].type);
  const double contacts = pinching_contacts(types.classes()[own].radius, wall.radius, wall_spacing, overlap);
  const auto law = law_at_wall(types, contact, own, wall);
  return stable_step(shape.mass / mobility(shape), contacts * law.stiffness(overlap),
                     contacts * law.damping(overlap));
}

double impact_overlap(const GrainShape& shape, const laws::LawParameters& law, double impact_speed) {
  return impact_overlap(ParticleTypes({{shape}}), among_themselves(law), 0, 0, impact_speed);
}

double critical_time_step(const GrainShape& shape, const laws::LawParameters& law, double impact_speed) {
  return critical_time_step(ParticleTypes({{shape}}), among_themselves(law), {}, impact_speed);
}

double critical_time_step_at_overlap(const GrainShape& shape, const laws::LawParameters& law,
                                     double overlap) {
  return critical_time_step_at_overlap(ParticleTypes({{shape}}), among_themselves(law), overlap, kNoLimit);
}

}  // namespace diefill::engine
