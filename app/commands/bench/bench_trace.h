// The motion of a bed over time, for comparison with another code.
#pragma once

#include <filesystem>

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::app {

/// Steps the simulation `steps` times and writes into `folder`, which is made: `energy.csv`, kinetic energies
/// every `every` steps, and `grains.csv`, the grains at the end, in the form of a bed of spheres
/// (process/laboratory/benchmark_bed.h) with the box centred on the origin. Throws results::ResultError where
/// they cannot be written.
void trace(engine::Simulation& simulation, int steps, int every, const std::filesystem::path& folder);

}  // namespace diefill::app
