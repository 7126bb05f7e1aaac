// CSV files of spheres: those of a clump, or grains at their places.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/powder/clump_union.h"
#include "process/input/table_reader.h"

namespace diefill::process {

/// What a sphere of a file may be; m.
struct SphereLimits {
  double farthest = 0;        ///< of each coordinate of the centre from 0
  double largest_radius = 0;  ///< the smallest is a nanometre
  std::size_t bytes = 0;      ///< of the file, at most
};

/// Of pour.grains_file.
inline constexpr SphereLimits kPlacedGrains = {10, 0.05, 1U << 28U};

/// Spheres and their lines in the file, from 1.
struct SphereRows {
  std::vector<engine::ClumpSphere> spheres;
  std::vector<int> lines;
};

/// Spheres of a file: a heading that names the columns x, y, z and radius with their units of length, in any
/// order, such as "x [mm], y [mm], z [mm], radius [mm]", then four numbers per line. Throws SceneError with
/// file, line and column for anything else; std::runtime_error when it is missing or too large.
SphereRows spheres_in_file(const std::filesystem::path& file, const SphereLimits& limits);

/// Those of the file under `key`, relative to the scene's folder. Throws SceneError.
SphereRows read_sphere_file(TableReader& table, const std::string& key, const SphereLimits& limits);

/// Throws SceneError, naming the lines, for two grains that are in each other by more than half the radius of
/// the smaller one: no powder at rest has them, and they would fly apart.
void refuse_grains_in_each_other(const SphereRows& grains, const std::filesystem::path& file);

}  // namespace diefill::process
