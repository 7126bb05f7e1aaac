// The longest time step that a powder allows, from the stiffest and lightest of its contacts, and the
// fraction of it that we take. Stiffness and damping are evaluated by the laws themselves.
#pragma once

#include "engine/contact/pair_laws.h"
#include "engine/powder/particle_types.h"

namespace diefill::engine {

/// Fraction of the critical step that a run takes when its scene names none. Without damping clumps gain
/// energy from 0.49 of the critical step on and spheres from 0.65 (STABILITY.md, time step): a fifth leaves a
/// factor of 2.4 for collisions faster than predicted, and resolves the stiffest one with about a dozen
/// steps. Bierwisch's 2e-6 s at d = 0.47 mm is 0.12 of the critical step at 0.7 m/s.
inline constexpr double kDefaultTimeStepFraction = 0.2;

/// Coordination number in the estimate of the static limit.
inline constexpr double kContactsPerGrain = 5;

/// How many times lighter a grain is to a force on its outermost sphere than to one through its centre: 1 +
/// b^2 m / I for the longest lever arm b; 1 for single spheres that do not rotate or turn under tangential
/// forces only. A grain of model D: 2.49.
double mobility(const GrainShape& shape);

/// Overlap (m) of a head-on collision of grains whose spheres of classes i and j meet at relative speed
/// `impact_speed` (m/s), undamped: where the work of repulsion less that of all attraction equals the kinetic
/// energy; at most the radius of the smaller sphere. For Hertz' law h = (5 m_eff v^2 / (4 k))^(2/5), k = 2/3
/// E~ sqrt(R_eff).
double impact_overlap(const ParticleTypes& types, const ContactLaws& contact, ClassNumber i, ClassNumber j,
                      double impact_speed);

/// Critical time step (s): the smallest limit of all pairs of sphere classes, and of classes at `walls`, at
/// the overlap of an impact at `impact_speed` (m/s), and of kContactsPerGrain contacts at a tenth of that
/// overlap, whose springs count alone (a grain is not hit at full speed from all sides). A spring k on a mass
/// m has the limit 2 sqrt(m / k), a damper c the limit 2 m / c: normal and tangential springs and dampers on
/// the reduced mass, lightened as forces on the grain's outermost point turn it, and rolling springs on the
/// reduced moment of inertia; in a packing they act on half of the smaller grain, as if it lay among grains
/// of its own size. Attraction from afar has the limit of crossing its steep part at 1.5 times the speed of
/// escape. The limit of a damper is what a rebound of a few steps allows (STABILITY.md, damping), twice that
/// of a contact that lasts: lasting_contact_time_step(). Throws what making the laws throws.
double critical_time_step(const ParticleTypes& types, const ContactLaws& contact,
                          const std::vector<WallSurface>& walls, double impact_speed);

/// Longest stable time step (s) of one contact that lasts: the smallest stable_step() of all pairs of sphere
/// classes, and of classes at `walls`, at a tenth of the overlap of an impact at `impact_speed` (m/s), for
/// the normal spring with its damper and the tangential spring with the damper of sliding, on the masses of
/// critical_time_step(). Without springs it is m / c, and without dampers 2 sqrt(m / k); it is never below
/// sqrt(2) - 1 of critical_time_step(). Throws what making the laws throws.
double lasting_contact_time_step(const ParticleTypes& types, const ContactLaws& contact,
                                 const std::vector<WallSurface>& walls, double impact_speed);

/// The critical time step for one contact among grains at overlaps of up to `overlap` (m) and
/// `overlap_over_radius`, of the radius of the smaller sphere, on half of the smaller grain, which others may
/// hold: what a run checks itself against. Which pair reached them does not matter: no pair has reached more.
double critical_time_step_at_overlap(const ParticleTypes& types, const ContactLaws& contact, double overlap,
                                     double overlap_over_radius);

/// The same for one contact at the overlap of a collision among grains at `impact_speed` (m/s), on the
/// reduced masses, as critical_time_step() has it: the damper's limit is that of a rebound, 2 m / c. A run
/// warns from half of it on, which is m / c, the limit of a contact that lasts.
double collision_time_step(const ParticleTypes& types, const ContactLaws& contact, double impact_speed);

/// Critical time step (s) of a sphere pinched between two tools, as under the edge of a shoe: at `overlap`
/// (m) it meets several wall spheres at distances of `wall_spacing` (m) on either side at once
/// (pinching_contacts()), and their stiffness and damping add up (stable_step()). Coarse grains on fine wall
/// spheres have less room than the laws of one contact say. Friction is left out: a pinched sphere slides.
double pinch_time_step(const ParticleTypes& types, const ContactLaws& contact, ClassNumber own,
                       const WallSurface& wall, double wall_spacing, double overlap);

// The same for grains of one type among themselves.

double impact_overlap(const GrainShape& shape, const laws::LawParameters& law, double impact_speed);
double critical_time_step(const GrainShape& shape, const laws::LawParameters& law, double impact_speed);
double critical_time_step_at_overlap(const GrainShape& shape, const laws::LawParameters& law, double overlap);

}  // namespace diefill::engine
