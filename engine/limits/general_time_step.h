// The longest time step that laws put together while the program runs allow: the limits of time_step.h, with
// stiffness and damping asked of the law itself.
#pragma once

#include "engine/contact/pair_loop.h"
#include "engine/powder/grain_shape.h"

namespace diefill::engine {

/// Overlap (m) of a head-on collision of two grains at relative speed `impact_speed` (m/s), undamped: where
/// the work of repulsion less that of all attraction equals the kinetic energy; at most one sphere radius.
double impact_overlap(const GrainShape& shape, const GeneralContact& contact, double impact_speed);

/// Critical time step (s): the smallest limit of the pairs grain-grain and grain-plane at the overlap of an
/// impact at `impact_speed` (m/s), and of kContactsPerGrain contacts at a tenth of that overlap. A spring k
/// on a mass m has the limit 2 sqrt(m / k), a damper c the limit 2 m / c: normal and tangential springs and
/// dampers on the reduced mass, lightened as forces on the grain's outermost point turn it, and rolling
/// springs on the reduced moment of inertia; attraction from afar has that of crossing its steep part at 1.5
/// times the speed of escape. `shape`: with moments of inertia as simulated (Simulation::settings()).
double critical_time_step(const GrainShape& shape, const GeneralContact& contact, double impact_speed);

/// The same of a pair of grains at a given overlap (m).
double critical_time_step_at_overlap(const GrainShape& shape, const GeneralContact& contact, double overlap);

/// As pinch_time_step() of time_step.h: a sphere at `overlap` (m) between wall spheres of `wall_radius` and
/// distance `wall_spacing` (m) on either side, its normal springs and dampers.
double pinch_time_step(const GrainShape& shape, const GeneralContact& contact, double wall_radius,
                       double wall_spacing, double overlap);

}  // namespace diefill::engine
