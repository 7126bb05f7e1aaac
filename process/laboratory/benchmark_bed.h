// Settled beds for benchmarks: dense, slow contacts, on which die filling spends its time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "engine/powder/new_grain.h"
#include "engine/simulation/settings.h"
#include "engine/walls/walls.h"

namespace diefill::process::laboratory {

enum class BenchmarkBed { spheres, clumps };

/// A bed's grains and everything else that a simulation of it needs. SI units.
struct BenchmarkBedState {
  engine::SimulationSettings settings;
  std::vector<engine::WallBodySpec> walls;
  std::vector<engine::NewGrain> grains;
};

/// What all beds of a kind have in common, without grains: law (Bierwisch 2009, Eqs. 2.3, 2.6, 2.7) with
/// E~ = 1e7 Pa, gamma_n / R = 1e6 Pa s/m, kappa_t / R = 1e6 Pa, mu = 0.5, a plane floor at z = 0 with R_eff =
/// R, 2e-6 s a step. `width` (m): period along x and y.
BenchmarkBedState empty_benchmark_bed(BenchmarkBed kind, double width);

/// The bed in a CSV file (plain or gzip), one row a grain, SI units, laboratory frame. Spheres: id, x, y, z,
/// vx, vy, vz, wx, wy, wz in a box of 12 mm; clumps: id, x, y, z, qw, qx, qy, qz (body to laboratory), vx,
/// vy, vz, wx, wy, wz in one of 7 mm; `width` (m) states another. The box begins at the origin. Throws
/// results::ResultError when the file cannot be read as such.
BenchmarkBedState read_benchmark_bed(BenchmarkBed kind, const std::filesystem::path& file, double width = 0);

/// `copies` x `copies` of a periodic bed side by side in one box: a larger bed in the very same state.
BenchmarkBedState side_by_side(const BenchmarkBedState& bed, int copies);

/// A bed of about `spheres` spheres as they fall, on a lattice just above the ground: let it fall for
/// `kBenchmarkBedFall` steps before timing.
BenchmarkBedState loose_benchmark_bed(BenchmarkBed kind, std::size_t spheres);
inline constexpr int kBenchmarkBedFall = 15000;

}  // namespace diefill::process::laboratory
