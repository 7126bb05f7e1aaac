// From the scene's powder and walls to the engine's numbers: coarse graining, grain shape, contact
// parameters.
#pragma once

#include "engine/simulation/simulation.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Overlap over the sphere radius beyond which a grain between moving tools is sheared off
/// (NumericsSpec::pinched_grains): past all that free powder reaches, and short of engine::HealthLimits. Time
/// steps are chosen so that few are to be sheared off sooner, as the step does not carry them
/// (engine::pinched_grains()).
inline constexpr double kShearingOverlap = 0.45;

/// Engine settings of a scene without walls and threads: grain shape at the wanted size, contact parameters
/// after coarse graining, options, and the time step. Where grains are of several sizes, `shape` is that of
/// the grain of mean mass, and `mix` has the kinds (mixed_powder.h). `impact_speed` (m/s) is the fastest
/// collision to be expected; the critical step is taken at it. Throws SceneError when a given time step is
/// above the critical one.
engine::SimulationSettings engine_settings(const Scene& scene, double impact_speed);

/// Critical time step (s) of those settings at `impact_speed` (m/s), grains and walls.
double critical_time_step(const engine::SimulationSettings& settings, double impact_speed);

/// s, longest step in which grains that the scene's moving tools wedge stay stable, with the margin of a step
/// that is chosen; infinite where no tool moves. `settings` are those of the scene.
double wedged_time_step(const Scene& scene, const engine::SimulationSettings& settings);

/// kg, mean of all grains that the scene lets in; those of `simulation` where they are alike.
double mean_grain_mass(const Scene& scene, const engine::Simulation& simulation);

/// m, radius of the smallest spheres of the powder with these settings.
double smallest_sphere(const engine::SimulationSettings& settings);

/// Solid fraction that the settled powder will have, roughly: sets how many grains a fill height needs. From
/// the settled beds of Bierwisch 2009, Table 4.4 for model A and D; models B and C lie between. A scene's own
/// estimate comes first.
double expected_solid_fraction(const Scene& scene);

}  // namespace diefill::process
