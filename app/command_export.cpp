#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/commands.h"
#include "app/exit_code.h"
#include "process/measure/earlier_instant.h"
#include "process/measure/gaussian_field.h"
#include "process/measure/stress_field.h"
#include "process/results/result_file.h"
#include "process/run/assemble.h"
#include "process/scene/units.h"
#include "render/paraview_files.h"

namespace diefill::app {

namespace {

using render::PointArray;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

PointArray vectors(const std::string& name, const std::vector<Eigen::Vector3d>& values) {
  PointArray array{name, 3, {}};
  for (const auto& value : values) array.values.insert(array.values.end(), value.begin(), value.end());
  return array;
}

template <class Value>
PointArray scalars(const std::string& name, std::size_t count, const Value& value) {
  PointArray array{name, 1, {}};
  for (std::size_t k = 0; k < count; ++k) array.values.push_back(value(k));
  return array;
}

/// What every grain knows of itself; open cells have no solid fraction and no stress.
std::vector<PointArray> grain_arrays(const results::FillResult& result) {
  const auto& powder = result.powder;
  const auto& fraction = result.solid_fraction;
  const std::size_t grains = powder.position.size();
  std::vector<PointArray> arrays = {
      scalars("id", grains, [&](std::size_t k) { return static_cast<double>(powder.id[k]); }),
      scalars("diameter [m]", grains, [&](std::size_t k) { return powder.diameter_of(k); }),
      vectors("velocity [m/s]", powder.velocity)};
  if (fraction.solid_fraction.size() == grains) {
    const auto closed = [&](std::size_t k, double value) { return fraction.open[k] != 0 ? kNone : value; };
    arrays.push_back(scalars("solid fraction", grains,
                             [&](std::size_t k) { return closed(k, fraction.solid_fraction[k]); }));
    arrays.push_back(
        scalars("in cavity", grains, [&](std::size_t k) { return fraction.in_cavity[k] != 0 ? 1.0 : 0.0; }));
    const auto& normal = result.contact_stress.normal;
    if (normal.size() == grains)
      arrays.push_back(scalars("pressure [Pa]", grains, [&](std::size_t k) {
        return closed(k, -normal[k].sum() / (3 * fraction.cell_volume[k]));
      }));
  }
  return arrays;
}

/// Over the cavity, or all powder where there is none; at most kMostPoints along an axis.
render::PointGrid grid_over(const results::FillResult& result, double spacing) {
  constexpr int kMostPoints = 400;
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
  grid.spacing = std::max(spacing, (upper - lower).maxCoeff() / (kMostPoints - 1));
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

/// The powder at all instants and at the end, and the file that strings them together.
void write_instants(const results::FillResult& result, const std::filesystem::path& out,
                    std::vector<std::filesystem::path>& written) {
  std::vector<std::pair<double, std::string>> series;
  const auto add = [&](const results::FillResult& then, const std::string& name) {
    render::write_points(out / name, then.powder.position, grain_arrays(then));
    written.push_back(out / name);
    series.emplace_back(then.powder.time, name);
  };
  for (std::size_t n = 0; n < result.instants.size(); ++n) {
    char name[32];
    std::snprintf(name, sizeof name, "powder_%04zu.vtp", n);
    add(process::result_at(result, result.instants[n].time, false), name);
  }
  add(result, "powder.vtp");
  if (series.size() == 1) return;
  render::write_series(out / "powder.pvd", series);
  written.push_back(out / "powder.pvd");
}

double averaging_width_of(const std::string& given, const results::FillResult& result) {
  if (given.empty()) return process::default_averaging_width(result.powder.grain_diameter);
  try {
    const double width = process::parse_quantity(given, process::Dimension::length);
    if (width > 0) return width;
  } catch (const process::UnitError& error) {
    throw process::SceneError("--averaging-width: found \"" + given + "\": " + error.what());
  }
  throw process::SceneError("--averaging-width: found \"" + given + "\"; it must be positive");
}

int export_results(const std::string& directory, const std::string& wanted_out, const std::string& width) {
  const auto result = results::read_results(directory);
  if (result.powder.position.empty())
    throw process::SceneError(directory + ": these results hold no powder; there is nothing to export");
  const double averaging_width = averaging_width_of(width, result);
  const std::filesystem::path out =
      wanted_out.empty() ? std::filesystem::path(directory) / "paraview" : std::filesystem::path(wanted_out);
  std::filesystem::create_directories(out);
  std::vector<std::filesystem::path> written;
  write_instants(result, out, written);
  render::write_tools(out / "tools.vtp", result.tools);
  written.push_back(out / "tools.vtp");
  const auto grid = grid_over(result, 0.5 * averaging_width);
  render::write_grid(out / "fields.vti", grid, grid_arrays(result, grid, averaging_width));
  written.push_back(out / "fields.vti");
  for (const auto& file : written) std::printf("%s\n", file.c_str());
  return kDone;
}

}  // namespace

void add_export(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("export", "Write results as VTK files, for ParaView");
  struct Arguments {
    std::string directory, out, averaging_width;
  };
  auto arguments = std::make_shared<Arguments>();
  command->add_option("DIR", arguments->directory, "results directory of a run")->required();
  command->add_option("--out", arguments->out, "directory for the files (default: DIR/paraview)");
  command->add_option("--averaging-width", arguments->averaging_width,
                      "Gaussian width sigma of the fields, such as '1 mm' (default: the larger of 0.5 mm and "
                      "half the grain size)");
  command->footer(
      "Writes powder.vtp (grains with velocity, solid fraction, pressure; one file more for each kept "
      "instant, "
      "and powder.pvd for all), tools.vtp, and fields.vti (Gaussian averages over the cavity). Lengths are "
      "in "
      "m.\n\nExample:\n  diefill export out/narrow_ring");
  command->callback([arguments, &chosen] {
    chosen = [arguments] {
      return export_results(arguments->directory, arguments->out, arguments->averaging_width);
    };
  });
}

}  // namespace diefill::app
