// Contact laws for benchmarks: those of other codes beside the law of the benchmark beds.
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/benchmark_bed.h"

namespace diefill::process::laboratory {

/// Names of the laws: "bierwisch" as beds have it; "hertz-mindlin" with a constant restitution, and "jkr",
/// the same with adhesion.
const std::vector<std::string>& benchmark_laws();

/// Gives a bed the law of that name: Hertz with E* = 1e7 Pa (or JKR with gamma = 0.005 J/m^2 between grains,
/// the floor does not attract), restitution 0.5, Mindlin's friction with Poisson's ratio 0.3 and mu = 0.5.
/// Throws std::invalid_argument for another name.
void set_benchmark_law(BenchmarkBedState& bed, const std::string& name);

}  // namespace diefill::process::laboratory
