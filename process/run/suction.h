// The effect on grains of air that a tool draws.
#pragma once

#include <optional>

#include "engine/contact/air_flow.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
struct SimulationSettings;
}  // namespace diefill::engine

namespace diefill::process {

/// m^2, permeability to air of powder of solid fraction phi that consists of particles of `diameter` (m):
/// d^2 (1 - phi)^3 / (180 phi^2) (Carman 1937, "Fluid flow through granular beds", after Kozeny 1927).
double permeability(double diameter, double solid_fraction);

/// The air flow of the scene's [suction]; none without that table. Darcy's law (1856): the pressure in the
/// air falls by viscosity / permeability times the flux against the grains, and pulls at every grain by that
/// gradient times the volume the grain stands for, solid volume over solid fraction. Acts on powder in the
/// cavity below the fill plane; the air in the shoe above stands at ambient pressure. Throws SceneError where
/// there is no cavity, or where the air would take grains along within a few time steps of `settings`.
std::optional<engine::AirFlow> air_flow_of(const Scene& scene, const Tooling& tooling,
                                           const engine::SimulationSettings& settings);

}  // namespace diefill::process
