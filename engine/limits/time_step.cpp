#include "engine/limits/time_step.h"

#include <algorithm>
#include <cmath>

#include "engine/limits/pinching_contacts.h"
#include "engine/limits/stable_step.h"

namespace diefill::engine {

double mobility(const GrainShape& shape) {
  if (!shape.rotates) return 1;
  const double lever = shape.bounding_radius() - shape.sphere_radius;
  return 1 + lever * lever * shape.mass / shape.inertia.minCoeff();
}

double impact_overlap(const GrainShape& shape, const ContactParameters& contact, double impact_speed) {
  const double reduced_mass = 0.5 * shape.mass;
  const double hertz = 2.0 / 3.0 * contact.reduced_modulus * std::sqrt(0.5 * shape.sphere_radius);
  return std::pow(1.25 * reduced_mass * impact_speed * impact_speed / hertz, 0.4);
}

double critical_time_step_at_overlap(const GrainShape& shape, const ContactParameters& contact,
                                     double overlap) {
  const double reduced_mass = 0.5 * shape.mass / mobility(shape);
  const double root = std::sqrt(0.5 * shape.sphere_radius * overlap);
  const double oscillator = 2 * std::sqrt(reduced_mass / (contact.reduced_modulus * root));
  if (contact.damping == 0) return oscillator;
  return std::min(oscillator, 2 * reduced_mass / (contact.damping * root));
}

double critical_time_step(const GrainShape& shape, const ContactParameters& contact, double impact_speed) {
  const double overlap = impact_overlap(shape, contact, impact_speed);
  const double impact = critical_time_step_at_overlap(shape, contact, overlap);
  const double stiffness = contact.reduced_modulus * std::sqrt(0.5 * shape.sphere_radius * 0.1 * overlap);
  const double packed = 2 * std::sqrt(shape.mass / mobility(shape) / (2 * kContactsPerGrain * stiffness));
  return std::min(impact, packed);
}

double pinch_time_step(const GrainShape& shape, const ContactParameters& contact, double wall_radius,
                       double wall_spacing, double overlap) {
  const double radius = shape.sphere_radius;
  const double contacts = pinching_contacts(radius, wall_radius, wall_spacing, overlap);
  const double mass = shape.mass / mobility(shape);
  const double root = std::sqrt(effective_radius(radius, wall_radius) * overlap);
  return stable_step(mass, contacts * contact.reduced_modulus * root, contacts * contact.damping * root);
}

}  // namespace diefill::engine
