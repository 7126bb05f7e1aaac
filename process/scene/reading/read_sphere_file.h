// CSV files of spheres: those of a clump, or grains at their places.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/powder/clump_union.h"
#include "process/input/table_reader.h"

namespace diefill::process {

/// Spheres of a file: a line such as "x [mm], y [mm], z [mm], radius [mm]", then four numbers a line. Throws
/// SceneError with file and line for anything else; std::runtime_error when it is missing or above `largest`
/// bytes.
std::vector<engine::ClumpSphere> spheres_in_file(const std::filesystem::path& file, std::size_t largest);

/// Those of the file under `key`, relative to the scene's folder. Throws SceneError.
std::vector<engine::ClumpSphere> read_sphere_file(TableReader& table, const std::string& key,
                                                  std::size_t largest);

}  // namespace diefill::process
