// From the scene's powder and walls to the engine's numbers: coarse graining, grain shape, contact
// parameters.
#pragma once

#include "engine/simulation.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Engine settings of a scene without walls and threads: grain shape at the wanted size, contact parameters
/// after coarse graining, options, and the time step. `impact_speed` (m/s) is the fastest collision to be
/// expected; the critical step is taken at it. Throws SceneError when a given time step is above the critical
/// one.
engine::SimulationSettings engine_settings(const Scene& scene, double impact_speed);

/// Critical time step (s) of those settings at `impact_speed` (m/s), grains and walls.
double critical_time_step(const engine::SimulationSettings& settings, double impact_speed);

/// Solid fraction that the settled powder will have, roughly: sets how many grains a fill height needs. From
/// the settled beds of Bierwisch 2009, Table 4.4 for model A and D; models B and C lie between. A scene's own
/// estimate comes first.
double expected_solid_fraction(const Scene& scene);

}  // namespace diefill::process
