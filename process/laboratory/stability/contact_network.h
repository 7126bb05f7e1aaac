// Touching grains as a network of linear springs: its fastest oscillation is what a time step must resolve.
#pragma once

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process::laboratory {

/// rad/s, largest eigenfrequency of the network of contacts as they are now, linearised, without damping and
/// sliding: the root of the largest eigenvalue of M^-1/2 K M^-1/2, by power iteration. Contacts are found
/// from the grains' positions, among grains of the first type and with a floor at z = 0; stiffnesses are the
/// law's. `period` of the simulation is respected. 0 where nothing touches.
double largest_eigenfrequency(const engine::Simulation& simulation);

}  // namespace diefill::process::laboratory
