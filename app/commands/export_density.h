// `diefill export --density-for MESH` and `--density-grid`: what a press simulation starts from.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::app {

/// As on the command line.
struct DensityOptions {
  std::string mesh, mesh_unit = "mm", grid, mass = "filled";
  std::vector<std::string> mesh_position;
  double mesh_share = 1;
  int cavity = 1;
  bool wanted() const { return !mesh.empty() || !grid.empty(); }
};

void add_density_options(CLI::App& command, DensityOptions& options);

/// Throws CLI::ValidationError, in one line, where one of these options is given that has no effect without
/// another that is not.
void require_density_wanted(const CLI::App& command);

/// Writes the files into `out`, prints what they hold and names elements outside the powder. Throws
/// process::SceneError, before anything is written, for a mesh that cannot be read or holds no powder.
void export_density(const results::FillResult& result, const DensityOptions& options, double averaging_width,
                    const std::filesystem::path& out);

}  // namespace diefill::app
