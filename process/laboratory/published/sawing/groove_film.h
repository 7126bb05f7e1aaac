// The grains of a groove over time, as results that `diefill film` and `diefill map` draw. Lengths and times
// are those of the process: the wire is 100 um thick.
#pragma once

#include <filesystem>

#include "process/laboratory/published/sawing/groove_measures.h"
#include "process/results/fill_result.h"

namespace diefill::process::laboratory::sawing {

/// A finished run.
struct FinishedGroove {
  const GrooveCase& shape;
  const GrooveParts& parts;
  const engine::FluidSimulation& simulation;
  std::uint64_t seed;
};

/// Particles of the grains, and the wire's place, as they are.
results::Instant instant_of(const engine::FluidSimulation& simulation, const GrooveParts& parts);

/// The end of the run and `instants` before it. Every particle of a grain is one of the result's, its
/// diameter that of its grain.
results::FillResult film_of(const FinishedGroove& finished, const std::vector<results::Instant>& instants);

/// Writes that as results.h5 into the folder. Throws results::ResultError.
void write_film(const std::filesystem::path& folder, const FinishedGroove& finished,
                const std::vector<results::Instant>& instants);

}  // namespace diefill::process::laboratory::sawing
