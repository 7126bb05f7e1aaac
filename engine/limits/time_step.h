// The longest time step that a powder allows, from its stiffest contact, and the fraction of it that we take.
#pragma once

#include "engine/laws/contact_parameters.h"
#include "engine/powder/grain_shape.h"

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
/// forces only. A D grain: 2.49 (physics reference, section 4.3).
double mobility(const GrainShape& shape);

/// Overlap (m) of a head-on collision of two grains at relative speed `impact_speed` (m/s), undamped Hertz:
/// h = (5 m_eff v^2 / (4 k))^(2/5), k = 2/3 E~ sqrt(R_eff).
double impact_overlap(const GrainShape& shape, const ContactParameters& contact, double impact_speed);

/// Critical time step (s): the smallest of the limits of the contact at the overlap of an impact at
/// `impact_speed` (m/s), 2 sqrt(m_eff / k_n) for one contact, 2 sqrt(m / (2 Z k_n)) for Z contacts at a tenth
/// of that overlap (a grain is not hit at full speed from all sides), and 2 m_eff / c for the damper, with m
/// lightened by mobility().
double critical_time_step(const GrainShape& shape, const ContactParameters& contact, double impact_speed);

/// Critical time step (s) of a sphere pinched between two tools, as under the edge of a shoe: at `overlap`
/// (m) it meets several wall spheres of radius `wall_radius` and distance `wall_spacing` (m) on either side
/// at once, about pi 2 h (R + R_w) / s^2 (spheres whose overlap with a plane of them is positive) with half
/// the overlap on average, and their stiffness and damping add up (stable_step()). Coarse grains on fine wall
/// spheres have less room than the laws of one contact say.
double pinch_time_step(const GrainShape& shape, const ContactParameters& contact, double wall_radius,
                       double wall_spacing, double overlap);

/// The same as critical_time_step() at a given overlap (m): what a run checks itself against.
double critical_time_step_at_overlap(const GrainShape& shape, const ContactParameters& contact,
                                     double overlap);

}  // namespace diefill::engine
