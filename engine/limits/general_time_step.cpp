#include "engine/limits/general_time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/limits/law_probe.h"
#include "engine/limits/pinching_contacts.h"
#include "engine/limits/stable_step.h"
#include "engine/limits/time_step.h"

namespace diefill::engine {

namespace {

using laws::PairProperties;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

PairProperties grain_pair(const GrainShape& shape) {
  return {shape.sphere_radius, shape.sphere_radius, shape.mass, shape.mass};
}

PairProperties wall_pair(const GrainShape& shape, double wall_radius) {
  return {shape.sphere_radius, wall_radius, shape.mass, kInfinite};
}

/// J, work of the first approach to `overlap` (m): Simpson's rule after h = H u^2, which is smooth where
/// forces begin with a root.
double work_of_approach(const LawProbe& probe, double overlap) {
  constexpr int kIntervals = 32;
  double sum = 0;
  for (int n = 1; n <= kIntervals; ++n) {
    const double u = static_cast<double>(n) / kIntervals;
    const double weight = n == kIntervals ? 1 : (n % 2 == 1 ? 4 : 2);
    sum += weight * probe.loading_force(overlap * u * u) * 2 * overlap * u;
  }
  return sum / (3.0 * kIntervals);
}

/// m: where the work of approach has used up `energy` (J), at most `deepest` (m).
double overlap_of_energy(const LawProbe& probe, double energy, double deepest) {
  if (!(energy > 0)) return 0;
  double high = 1e-6 * deepest;
  while (high < deepest && work_of_approach(probe, high) < energy) high = std::min(2 * high, deepest);
  double low = 0;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (work_of_approach(probe, middle) < energy ? low : high) = middle;
  }
  return high;
}

double collision_overlap(const LawProbe& probe, double mass, double speed, double deepest) {
  return overlap_of_energy(probe, 0.5 * mass * speed * speed + probe.energy_of_approach(), deepest);
}

/// s: of a collision and of a packing, for a pair of reduced `mass` (kg) and these masses of a contact.
double critical_of_pair(const LawProbe& probe, const GrainShape& shape, double mass,
                        const ContactMasses& masses, double speed) {
  const double overlap = collision_overlap(probe, mass, speed, shape.sphere_radius);
  const double impact = step_limit(probe.springs(overlap), masses, 1);
  // Many contacts share what damping there is: their springs alone, as in time_step.h.
  ContactSprings packed = probe.springs(0.1 * overlap);
  packed.damping = packed.sliding_damping = 0;
  return std::min({impact, step_limit(packed, masses, kContactsPerGrain), crossing_time(probe, mass)});
}

}  // namespace

double impact_overlap(const GrainShape& shape, const GeneralContact& contact, double impact_speed) {
  const LawProbe probe(contact.grains, contact.scaling, grain_pair(shape));
  return collision_overlap(probe, 0.5 * shape.mass, impact_speed, shape.sphere_radius);
}

double critical_time_step(const GrainShape& shape, const GeneralContact& contact, double impact_speed) {
  const ContactMasses masses = masses_of(shape);
  const LawProbe grains(contact.grains, contact.scaling, grain_pair(shape));
  const LawProbe walls(contact.walls, contact.scaling, wall_pair(shape, kInfinite));
  return std::min(
      critical_of_pair(grains, shape, 0.5 * shape.mass, half_of_smaller(masses, masses), impact_speed),
      critical_of_pair(walls, shape, shape.mass, masses, impact_speed));
}

double critical_time_step_at_overlap(const GrainShape& shape, const GeneralContact& contact, double overlap) {
  const LawProbe probe(contact.grains, contact.scaling, grain_pair(shape));
  const ContactMasses masses = masses_of(shape);
  return step_limit(probe.springs(overlap), half_of_smaller(masses, masses), 1);
}

double pinch_time_step(const GrainShape& shape, const GeneralContact& contact, double wall_radius,
                       double wall_spacing, double overlap) {
  const LawProbe probe(contact.walls, contact.scaling, wall_pair(shape, wall_radius));
  const double contacts = pinching_contacts(shape.sphere_radius, wall_radius, wall_spacing, overlap);
  // Coulomb's limit holds the others, as a pinched sphere slides.
  const ContactSprings springs = probe.springs(overlap);
  return stable_step(shape.mass / mobility(shape), contacts * springs.normal, contacts * springs.damping);
}

}  // namespace diefill::engine
