#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/export_density.h"
#include "app/commands/shared_options/measured_region.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "app/pictures/paraview_series.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/fields/stress_field.h"
#include "process/results/storage/result_file.h"
#include "process/run/assemble.h"
#include "process/tooling/progress.h"
#include "render/scene3d/paraview_files.h"

namespace diefill::app {

namespace {

using render::PointArray;

/// Over the cavity, or all powder where there is none; at most kMaxPoints along an axis.
render::PointGrid grid_over(const results::FillResult& result, double spacing) {
  constexpr int kMaxPoints = 400;
  Eigen::Vector3d lower = result.cavity.lower_corner, upper = result.cavity.upper_corner;
  if (!(result.cavity.volume > 0)) {
    lower.setConstant(std::numeric_limits<double>::max());
    upper = -lower;
    for (const auto& place : result.powder.position) {
      lower = lower.cwiseMin(place);
      upper = upper.cwiseMax(place);
    }
  }
  render::PointGrid grid;
  grid.origin = lower;
  grid.spacing = std::max(spacing, (upper - lower).maxCoeff() / (kMaxPoints - 1));
  grid.counts = ((upper - lower) / grid.spacing).array().ceil().cast<int>() + 1;
  return grid;
}

/// Gaussian averages on the grid's points.
std::vector<PointArray> grid_arrays(const results::FillResult& result, const render::PointGrid& grid,
                                    double averaging_width) {
  const process::GaussianField fraction(result.powder, result.solid_fraction, averaging_width);
  std::vector<PointArray> arrays = {{"solid fraction", 1, {}}};
  std::unique_ptr<process::StressField> stress;
  if (!result.contact_stress.normal.empty()) {
    stress = std::make_unique<process::StressField>(result, averaging_width);
    arrays.push_back({"pressure [Pa]", 1, {}});
  }
  for (int z = 0; z < grid.counts.z(); ++z)
    for (int y = 0; y < grid.counts.y(); ++y)
      for (int x = 0; x < grid.counts.x(); ++x) {
        const Eigen::Vector3d point = grid.point(x, y, z);
        arrays[0].values.push_back(fraction.at(point));
        if (stress) arrays[1].values.push_back(stress->pressure(point));
      }
  return arrays;
}

/// The powder at the end, and powder and tools at all instants where the results hold any.
std::vector<std::filesystem::path> write_powder(const results::FillResult& result,
                                                const std::filesystem::path& out, const FieldWriter& fields) {
  process::Progress progress(true);
  auto written = write_filling_series(result, out, out / "filling.pvd", fields, progress.callback());
  if (!written.empty()) return written;
  render::write_points(out / "powder.vtp", result.powder.position, grain_arrays(result));
  return {out / "powder.vtp"};
}

int export_results(const std::string& directory, const std::string& wanted_out, const std::string& width,
                   const DensityOptions& density) {
  const std::filesystem::path out =
      wanted_out.empty() ? std::filesystem::path(directory) / "paraview" : std::filesystem::path(wanted_out);
  if (!wanted_out.empty()) require_directory(out);
  const auto result = results::read_results(directory);
  if (result.powder.position.empty())
    throw process::SceneError(directory +
                              ": the results contain no powder to export; run the scene again with powder");
  const double averaging_width = averaging_width_of(width, {&result});
  if (density.wanted()) {
    export_density(result, density, averaging_width, out);
    return kDone;
  }
  make_output_directory(out);
  const auto grid = grid_over(result, 0.5 * averaging_width);
  const FieldWriter write_fields = [&](const results::FillResult& then, const std::filesystem::path& file) {
    render::write_grid(file, grid, grid_arrays(then, grid, averaging_width));
  };
  std::vector<std::filesystem::path> written;
  write_output([&] {
    written = write_powder(result, out, write_fields);
    render::write_tools(out / "tools.vtp", result.tools);
    written.push_back(out / "tools.vtp");
    if (!result.instants.empty()) return;
    write_fields(result, out / "fields.vti");
    written.push_back(out / "fields.vti");
  });
  for (const auto& file : written) std::printf("%s\n", file.c_str());
  return kDone;
}

}  // namespace

void add_export(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("export", "Write results as VTK files, for ParaView");
  struct Arguments {
    std::string directory, out, averaging_width;
    DensityOptions density;
  };
  auto arguments = std::make_shared<Arguments>();
  command->add_option("DIR", arguments->directory, "results directory of a run")->required();
  command->add_option("--out", arguments->out, "directory for the files (default: DIR/paraview)");
  command->add_option("--averaging-width", arguments->averaging_width,
                      "Gaussian width sigma of the fields, such as '1 mm' (default: that of the run's own "
                      "fields)");
  add_density_options(*command, arguments->density);
  command->footer(
      "Writes powder.vtp (grains with velocity, solid fraction, pressure), tools.vtp, and fields.vti "
      "(Gaussian\naverages over the cavity). If the scene sets measure.snapshot_interval, also writes "
      "filling.pvd, which plays powder,\ntools and fields over time, and its files powder_*.vtp, tool_*.vtp "
      "and fields_*.vti. Lengths are in m.\n\n"
      "With --density-for or --density-grid it writes the density instead: CSV, VTU or VTI, and\n"
      "*INITIAL CONDITIONS cards for Abaqus (relative density) and CalculiX.\n\n"
      "Examples:\n  diefill export out/narrow_ring\n"
      "  diefill export out/stepped_part --density-for stepped_part.msh --mesh-unit mm\n"
      "  diefill export out/stepped_part --density-grid '0.5 mm'");
  command->callback([arguments, command, &chosen] {
    require_density_wanted(*command);
    chosen = [arguments] {
      return export_results(arguments->directory, arguments->out, arguments->averaging_width,
                            arguments->density);
    };
  });
}

}  // namespace diefill::app
