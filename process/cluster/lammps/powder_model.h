// What every rank knows of a simulation: types, laws, tools and numerics, made from the settings that rank 0
// sends.
#pragma once

#include <vector>

#include "engine/simulation/simulation.h"
#include "process/cluster/lammps/packet.h"

namespace diefill::process::cluster {

/// The model of a simulation on one rank.
struct PowderModel {
  engine::SimulationSettings settings;  ///< types as they move
  engine::ParticleTypes types;
  std::vector<engine::WallBody> bodies;
  /// Number that wall sphere k of body b has in the simulation, at [b][k]: searches sort them.
  std::vector<std::vector<std::uint32_t>> wall_number;
  double skin = 0;       ///< m, by how much near spheres may come nearer before a search
  double law_range = 0;  ///< m, gap up to which grains act on each other

  std::size_t spheres() const { return types.spheres(); }
  /// m, largest distance of the centres of grains of two types at which they act on each other.
  double reach(std::size_t type, std::size_t other) const;
};

/// Bytes of the model of `simulation`.
Packet model_message(const engine::Simulation& simulation);
/// The model from such bytes.
PowderModel read_model(Packet& message);

}  // namespace diefill::process::cluster
