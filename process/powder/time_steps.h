// Time steps of a scene: what its powder and tools allow, and the one used.
#pragma once

#include "process/scene/scene.h"

namespace diefill::engine {
struct SimulationSettings;
}  // namespace diefill::engine

namespace diefill::process {

/// Overlap over the sphere radius beyond which a grain between moving tools is sheared off
/// (NumericsSpec::pinched_grains): past all that free powder reaches, and short of engine::ValidityLimits.
/// Time steps are chosen so that few are to be sheared off sooner, as the step does not carry them
/// (engine::pinched_grains()).
inline constexpr double kShearingOverlap = 0.45;

/// Critical time step (s) of those settings at `impact_speed` (m/s), grains and walls.
double critical_time_step(const engine::SimulationSettings& settings, double impact_speed);

/// Longest stable step (s) of one contact of those settings that lasts after an impact at `impact_speed`
/// (m/s): shorter than the critical one where contacts are strongly damped
/// (engine::lasting_contact_time_step()).
double lasting_contact_time_step(const engine::SimulationSettings& settings, double impact_speed);

/// s, longest step in which grains that the scene's moving tools wedge stay stable, with the margin of a step
/// that is chosen; infinite where no tool moves. `settings` are those of the scene.
double wedged_time_step(const Scene& scene, const engine::SimulationSettings& settings);

/// s: the scene's own, or the usual share of the critical step at `impact_speed` (m/s) and of what wedged
/// grains allow. Throws SceneError when the scene's own step, or the one of its own share, is not below the
/// critical one and that of lasting contacts.
double chosen_time_step(const Scene& scene, const engine::SimulationSettings& settings, double impact_speed);

}  // namespace diefill::process
