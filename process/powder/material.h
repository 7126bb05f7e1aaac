// From the scene's powder and walls to the engine's numbers: coarse graining, grain shape, contact
// parameters.
#pragma once

#include "engine/simulation/settings.h"
#include "process/powder/mixed_powder.h"
#include "process/powder/time_steps.h"
#include "process/scene/scene.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

struct PowderInflow;

/// Engine settings of a scene without walls and threads: particle types at the wanted size, contact laws
/// after coarse graining, options, and the time step. `impact_speed` (m/s) is the fastest collision to be
/// expected; the critical step is taken at it. Throws SceneError when a given time step is above the critical
/// one.
engine::SimulationSettings engine_settings(const Scene& scene, double impact_speed);

/// kg, mean of all grains that the step lets in; those of `simulation` where they are alike.
double mean_grain_mass(const Scene& scene, const PowderInflow& inflow, const engine::Simulation& simulation);

/// m, radius of the smallest spheres of the powder with these settings.
double smallest_sphere(const engine::SimulationSettings& settings);

/// Solid fraction that the settled powder will have, roughly: sets how many grains a fill height needs. From
/// the settled beds of Bierwisch 2009, Table 4.4 for model A and D; models B and C lie between. A scene's own
/// estimate comes first.
double expected_solid_fraction(const Scene& scene);

}  // namespace diefill::process
