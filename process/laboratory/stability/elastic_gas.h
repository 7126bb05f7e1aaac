// A gas of grains without dissipation between two plates: its energy must stay, and grows where the time step
// is too long (Hu 2024, section 4.4; there periodic along all three axes).
#pragma once

#include "engine/powder/new_grain.h"
#include "engine/simulation/settings.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

struct ElasticGas {
  engine::SimulationSettings settings;  ///< without a time step
  std::vector<engine::WallBodySpec> walls;
  std::vector<engine::NewGrain> grains;
};

/// `across`^3 grains on a lattice of constant `spacing` (m) at random orientations, velocities Gaussian with
/// `speed` (m/s) rms per component, spins such that rims move as fast.
ElasticGas elastic_gas(const engine::GrainShape& shape, const engine::ContactParameters& contact, int across,
                       double spacing, double speed);

/// Spurious energy gain in `duration` (s) with steps of `time_step` (s), over the kinetic energy at the
/// start; infinite where the run was lost or gained more than all it had.
double energy_growth(const ElasticGas& gas, double time_step, double duration);

}  // namespace diefill::process::laboratory
