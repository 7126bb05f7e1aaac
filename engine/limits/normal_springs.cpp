#include "engine/limits/normal_springs.h"

#include <cmath>
#include <limits>

#include "engine/contact/pair_laws.h"
#include "engine/laws/damping.h"
#include "engine/laws/hertz.h"

namespace diefill::engine {

namespace {

NormalSpring spring_of(const laws::GeneralContactLaw& law, double overlap) {
  return {law.stiffness(overlap), law.damping(overlap)};
}

/// Of Bierwisch's law. Radii and overlap in m. Cohesion, which makes contacts softer, is left out.
NormalSpring spring_of(const ContactParameters& contact, double radius, double other_radius, double overlap) {
  const double effective = effective_radius(radius, other_radius), root = std::sqrt(overlap);
  return {laws::Hertz(contact.reduced_modulus, effective).stiffness(root),
          laws::HertzianDamping(contact.damping, effective).at(root)};
}

}  // namespace

NormalSpring spring_between(const Simulation& simulation, std::size_t grain, std::size_t other,
                            double overlap) {
  const SimulationSettings& settings = simulation.settings();
  const Grains& grains = simulation.grains();
  if (settings.mix)
    return spring_of(
        law_of_kinds(simulation.kinds(), *settings.mix, grains.kind_of(grain), grains.kind_of(other)),
        overlap);
  const double radius = settings.shape.sphere_radius, mass = settings.shape.mass;
  if (const auto& contact = settings.general_contact)
    return spring_of(laws::GeneralContactLaw(contact->grains, contact->scaling, {radius, radius, mass, mass}),
                     overlap);
  return spring_of(settings.grain_contact, radius, radius, overlap);
}

NormalSpring spring_at_tool(const Simulation& simulation, std::size_t grain, std::size_t body,
                            double overlap) {
  const SimulationSettings& settings = simulation.settings();
  const WallBody& wall = simulation.bodies()[body];
  if (settings.mix)
    return spring_of(law_with_wall(simulation.kinds(), *settings.mix, simulation.grains().kind_of(grain),
                                   wall.material(), wall.contact_radius()),
                     overlap);
  const double radius = settings.shape.sphere_radius;
  if (const auto& contact = settings.general_contact)
    return spring_of(laws::GeneralContactLaw(contact->walls, contact->scaling,
                                             {radius, wall.contact_radius(), settings.shape.mass,
                                              std::numeric_limits<double>::infinity()}),
                     overlap);
  return spring_of(wall.contact().value_or(settings.wall_contact), radius, wall.contact_radius(), overlap);
}

}  // namespace diefill::engine
