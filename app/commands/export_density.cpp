#include "app/commands/export_density.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "app/backup_notes.h"
#include "app/commands/shared_options/measured_region.h"
#include "app/options/choices.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/options/quantities.h"
#include "app/output.h"
#include "process/input/scene_error.h"
#include "process/measure/choose_cavity.h"
#include "process/measure/fields/element_density.h"
#include "process/measure/measure.h"
#include "process/press_mesh/density_files.h"
#include "process/press_mesh/density_grid.h"
#include "process/press_mesh/read_press_mesh.h"
#include "process/results/cavity_rows.h"
#include "process/results/formatted.h"
#include "process/results/storage/atomic_file.h"
#include "render/scene3d/paraview_files.h"
#include "render/scene3d/solid_mesh_vtu.h"

namespace diefill::app {
namespace {

/// m: --mesh-unit.
double mesh_unit(const std::string& name) {
  const std::vector<std::string> usual = {"m", "dm", "cm", "mm", "um", "nm", "inch", "ft"};
  try {
    const bool number = name.find_first_of("0123456789.") != std::string::npos;  // "1 2 mm" is no unit
    if (!number) return positive_quantity("--mesh-unit", "1 " + name, process::Dimension::length);
  } catch (const process::SceneError&) {  // said below, with the units that are
  }
  throw process::SceneError("--mesh-unit: " + unknown_name(name, usual));
}

results::SolidMesh read_mesh(const DensityOptions& options) {
  const std::filesystem::path file = options.mesh;
  const double unit = mesh_unit(options.mesh_unit);
  const std::string ending = ending_of(file);
  results::SolidMesh mesh;
  if (ending == ".msh") {
    mesh = process::read_gmsh(file, unit);
  } else if (ending == ".inp") {
    mesh = process::read_inp(file, unit);
  } else if (ending == ".vtu") {
    try {
      mesh = render::read_vtu(file, unit);
    } catch (const std::invalid_argument& error) {
      throw process::SceneError(options.mesh + ": " + error.what());
    }
  } else {
    throw process::SceneError("--density-for: found \"" + options.mesh +
                              "\", allowed: a mesh ending in .vtu, .msh (Gmsh) or .inp (Abaqus, CalculiX)");
  }
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t axis = 0; axis < options.mesh_position.size(); ++axis)
    shift[static_cast<Eigen::Index>(axis)] = coordinate("--mesh-position", options.mesh_position[axis]);
  for (auto& node : mesh.nodes) node += shift;
  return mesh;
}

/// kg. The names that --mass takes too are words, so that a number in front tells it from them.
double mass_given(const std::string& text) {
  if (text.find_first_of("0123456789") != std::string::npos)
    return positive_quantity("--mass", text, process::Dimension::mass);
  throw process::SceneError("--mass: " + unknown_name(text, {"filled", "expected"}) +
                            ", or a mass, such as '12.3 g'");
}

/// kg, of the whole cavity.
double cavity_mass(const results::FillResult& result, const DensityOptions& options) {
  if (options.mass == "filled") {
    const double mass = process::filled_mass(result.powder, result.solid_fraction);
    if (mass > 0) return mass;
    if (!(result.cavity.volume > 0))
      throw process::SceneError(
          "--mass filled: the results have no cavity whose mass is known; give the mass, such as '12.3 g'");
    throw process::SceneError(
        "--mass filled: the cavity holds no powder; fill it, or give the mass, such as '12.3 g'");
  }
  if (options.mass != "expected") return mass_given(options.mass);
  const std::string prefix = options.cavity > 1 ? results::figure_prefix(options.cavity) : "";
  for (const char* figure : {"expected_mass_kg", "estimated_mass_kg"}) {
    const auto found = result.figures.find(prefix + figure);
    if (found != result.figures.end() && found->second > 0) return found->second;
  }
  throw process::SceneError(
      "--mass expected: the report has no mass of the real powder; give it, such as '12.3 g'");
}

/// kg/m^3, of the solid that the mass consists of: the metal's, but for model powder; 0: the grains'.
double solid_of(const results::FillResult& result, const DensityOptions& options) {
  const auto metal = result.figures.find("solid_density_kg_m3");
  return options.mass == "filled" || metal == result.figures.end() ? 0 : metal->second;
}

/// Results of an earlier version do not tell the metal's density.
void note_unknown_solid(const results::FillResult& result, const DensityOptions& options) {
  if (options.mass != "filled" && !(solid_of(result, options) > 0))
    print_note(
        "the results do not tell the density of the real powder's solid: relative densities refer to that of "
        "the grains");
}

std::string box_text(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  return results::formatted("x %.4g to %.4g, y %.4g to %.4g, z %.4g to %.4g mm", 1e3 * lower.x(),
                            1e3 * upper.x(), 1e3 * lower.y(), 1e3 * upper.y(), 1e3 * lower.z(),
                            1e3 * upper.z());
}

process::ElementDensity density_of(const results::FillResult& result, const results::SolidMesh& mesh,
                                   const DensityOptions& options, double averaging_width) {
  const double mass = options.mesh_share * cavity_mass(result, options);
  try {
    return process::element_density(result, mesh, {averaging_width, mass, solid_of(result, options)});
  } catch (const std::invalid_argument&) {
    Eigen::Vector3d lower = mesh.nodes.front(), upper = lower;
    for (const auto& node : mesh.nodes) lower = lower.cwiseMin(node), upper = upper.cwiseMax(node);
    throw process::SceneError(options.mesh + ": no element lies in the powder: the mesh spans " +
                              box_text(lower, upper) + ", the cavity " +
                              box_text(result.cavity.lower_corner, result.cavity.upper_corner) +
                              "; see --mesh-unit and --mesh-position");
  }
}

/// Its volume in m^3, and its longest extent in m along each axis.
struct MeshSize {
  double volume = 0;
  Eigen::Vector3d extents = Eigen::Vector3d::Zero();
};

/// The unit in which a mesh of `metres` a unit would be as large as the powder; empty where there is none.
std::string unit_that_fits(const MeshSize& mesh, double metres, const MeshSize& powder) {
  constexpr double kLarger = 1.2, kSmaller = 0.5;  // the mesh over the powder
  for (const char* name : {"mm", "m", "inch", "cm", "um", "ft"}) {
    const double factor = mesh_unit(name) / metres,
                 volume = mesh.volume * std::pow(factor, 3) / powder.volume;
    const bool within = ((factor * mesh.extents).array() <= kLarger * powder.extents.array()).all();
    if (within && volume >= kSmaller && volume <= kLarger) return name;
  }
  return "";
}

/// Throws where the mesh has many times the volume of the powder, and just that of it in another unit. A mesh
/// with tools in it may be large, but is in no unit as large as the powder alone.
void refuse_wrong_unit(const results::FillResult& result, const results::SolidMesh& mesh,
                       const DensityOptions& options) {
  constexpr double kDoubtful = 5;
  const double expected = options.mesh_share * result.cavity.volume;
  double volume = 0;
  for (const auto& element : mesh.elements)
    for (const auto& part : results::tetrahedra_of(mesh, element))
      volume += std::abs(results::signed_volume(part));
  if (!(expected > 0 && volume > kDoubtful * expected)) return;
  Eigen::Vector3d lower = mesh.nodes.front(), upper = lower;
  for (const auto& node : mesh.nodes) lower = lower.cwiseMin(node), upper = upper.cwiseMax(node);
  const std::string unit =
      unit_that_fits({volume, upper - lower}, mesh_unit(options.mesh_unit),
                     {expected, result.cavity.upper_corner - result.cavity.lower_corner});
  if (unit.empty()) return;
  throw process::SceneError(
      "--mesh-unit: found \"" + options.mesh_unit + "\", in which " + options.mesh +
      results::formatted(" has %.4g times the volume of the powder it stands for (%.6g mm^3); in ",
                         volume / expected, 1e9 * expected) +
      unit + " it is as large: give --mesh-unit " + unit);
}

/// "17, 18, 23 and 4 more".
std::string list_text(const std::vector<std::uint64_t>& numbers) {
  constexpr std::size_t kMax = 20;
  std::string text;
  for (std::size_t n = 0; n < std::min(kMax, numbers.size()); ++n)
    text += (n == 0 ? "" : ", ") + std::to_string(numbers[n]);
  if (numbers.size() > kMax) text += " and " + std::to_string(numbers.size() - kMax) + " more";
  return text;
}

void print_density(const results::FillResult& result, const results::SolidMesh& mesh,
                   const process::ElementDensity& density, const DensityOptions& options) {
  double mass = 0, least = 1e300, most = 0;
  for (std::size_t e = 0; e < density.mass.size(); ++e) {
    mass += density.mass[e];
    if (!(density.relative[e] > 0)) continue;
    least = std::min(least, density.relative[e]);
    most = std::max(most, density.relative[e]);
  }
  std::printf("mesh: %zu elements, %zu nodes, %.6g mm^3", mesh.elements.size(), mesh.nodes.size(),
              1e9 * density.total_volume);
  if (mesh.left_out > 0) std::printf("; %zu elements without volume left out", mesh.left_out);
  std::printf("\nmass of the elements: %.7g g\n", 1e3 * mass);
  std::printf("relative density: mean %.4f, %.4f to %.4f; solid %.0f kg/m^3\n",
              mass / (density.solid_density * density.total_volume), least, most, density.solid_density);
  std::printf("factor that conserves the mass: %.4f\n", density.scale);
  if (!density.outside.empty())
    std::printf("outside the powder: %zu elements: %s\n", density.outside.size(),
                list_text(density.outside).c_str());
  if (!density.above.empty())
    print_note(std::to_string(density.above.size()) + " elements come out denser than their solid: " +
               list_text(density.above) + "; the cards keep what they get, so check mesh and mass");
  constexpr double kDifference = 0.05;
  const double expected = options.mesh_share * result.cavity.volume;
  if (expected > 0 && std::abs(density.total_volume / expected - 1) > kDifference)
    std::fprintf(
        stderr,
        "diefill: the mesh has %.0f %% of the volume of %s (%.6g mm^3), but is assigned its whole mass; "
        "for a quarter model give --mesh-share 0.25\n",
        100 * density.total_volume / expected,
        options.mesh_share == 1 ? "the cavity" : "that share of the cavity", 1e9 * expected);
}

using Files = std::vector<std::filesystem::path>;

void write_mesh_density(const results::FillResult& result, const DensityOptions& options,
                        double averaging_width, const std::filesystem::path& out, Files& written) {
  const results::SolidMesh mesh = read_mesh(options);
  refuse_wrong_unit(result, mesh, options);
  const auto density = density_of(result, mesh, options, averaging_width);
  make_output_directory(out);
  print_density(result, mesh, density, options);
  const std::string stem = process::file_stem(options.mesh);
  const process::DensityNote note{std::filesystem::path(options.mesh).filename().string(), result.title};
  for (auto& file : process::write_density_files(out, stem, mesh, density, note))
    written.push_back(std::move(file));
  const auto in_kg = [&](std::vector<double> relative) {
    for (double& value : relative) value *= density.solid_density;
    return relative;
  };
  written.push_back(out / (stem + "_density.vtu"));
  render::write_vtu(
      written.back(), mesh,
      {{"relative density", 1, density.node_relative}, {"density [kg/m^3]", 1, in_kg(density.node_relative)}},
      {{"relative density", 1, density.relative},
       {"density [kg/m^3]", 1, in_kg(density.relative)},
       {"mass [kg]", 1, density.mass},
       {"share in powder", 1, density.filled}});
}

/// m, of --density-grid; nothing without it.
std::optional<double> grid_spacing(const results::FillResult& result, const DensityOptions& options) {
  if (options.grid.empty()) return std::nullopt;
  return bounded_quantity("--density-grid", options.grid, process::Dimension::length,
                          {0, largest_edge(result), true, "the largest edge of the cavity"});
}

process::DensityGrid grid_of(const results::FillResult& result, const DensityOptions& options, double spacing,
                             double averaging_width) {
  try {
    return process::density_grid(result, spacing,
                                 {averaging_width, cavity_mass(result, options), solid_of(result, options)});
  } catch (const std::invalid_argument& error) {
    throw process::SceneError("--density-grid: found \"" + options.grid + "\": " + error.what());
  }
}

void write_grid_density(const process::DensityGrid& grid, const std::filesystem::path& out, Files& written) {
  written.push_back(out / "density_grid.csv");
  results::write_text_atomically(written.back(), process::density_grid_csv(grid));
  written.push_back(out / "density_grid.vti");
  render::write_cells(written.back(), {grid.origin, grid.spacing, grid.cells},
                      {{"relative density", 1, grid.relative}, {"mass [kg]", 1, grid.mass}});
}

}  // namespace

void add_density_options(CLI::App& command, DensityOptions& options) {
  const std::string group = "For a press simulation";
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->group(group);
  };
  add("--density-for", options.mesh,
      "finite-element mesh (.vtu, .msh of Gmsh, .inp of Abaqus or CalculiX): write the density of its "
      "elements "
      "and nodes");
  add("--mesh-unit", options.mesh_unit, "unit of length of the mesh")->capture_default_str();
  add("--mesh-position", options.mesh_position,
      "where the mesh's origin is in the scene, such as '0 mm' '0 mm' '-5 mm'")
      ->expected(3);
  add("--mesh-share", options.mesh_share,
      "share of the cavity that the mesh covers, such as 0.25 of a quarter model")
      ->check(number_within(1e-6, 1.0))
      ->capture_default_str();
  add("--mass", options.mass,
      "mass of the cavity that the elements share: filled (of the model powder), expected (of the real "
      "powder, "
      "as in the report), or as weighed, such as '12.3 g'")
      ->capture_default_str();
  add("--density-grid", options.grid,
      "edge of the cells of a regular grid over the cavity, such as '1 mm': write density_grid.csv and .vti");
  add("--cavity", options.cavity, "cavity by its number in the report")
      ->check(whole_number(1, 1000000))
      ->capture_default_str();
}

void require_density_wanted(const CLI::App& command) {
  const bool mesh = command.count("--density-for") > 0, grid = command.count("--density-grid") > 0;
  const auto refuse = [&](const char* option, const char* missing) {
    if (command.count(option) > 0)
      throw CLI::ValidationError(std::string(option) + ": has no effect without " + missing +
                                 "; give that too, or leave the option out");
  };
  for (const char* option : {"--mesh-unit", "--mesh-position", "--mesh-share"})
    if (!mesh) refuse(option, "--density-for");
  for (const char* option : {"--mass", "--cavity"})
    if (!mesh && !grid) refuse(option, "--density-for or --density-grid");
}

void export_density(const results::FillResult& whole, const DensityOptions& options, double averaging_width,
                    const std::filesystem::path& out) {
  results::FillResult result = whole;
  try {
    process::choose_cavity(result, options.cavity);
  } catch (const std::invalid_argument& error) {
    throw process::SceneError("--cavity: " + std::string(error.what()));
  }
  const auto spacing = grid_spacing(result, options);
  if (result.solid_fraction.solid_fraction.size() != result.powder.position.size() ||
      std::find(result.solid_fraction.open.begin(), result.solid_fraction.open.end(), 0) ==
          result.solid_fraction.open.end())
    throw process::SceneError(std::string(options.mesh.empty() ? "--density-grid" : "--density-for") +
                              ": the result holds no measured solid fraction, as where its cavity took no "
                              "powder or the run did not "
                              "end; run the scene to its end");
  std::optional<process::DensityGrid> grid;
  if (spacing) grid = grid_of(result, options, *spacing, averaging_width);
  Files written;
  write_output([&] {
    if (!options.mesh.empty()) write_mesh_density(result, options, averaging_width, out, written);
    if (!grid) return;
    make_output_directory(out);
    write_grid_density(*grid, out, written);
  });
  note_unknown_solid(result, options);
  for (const auto& file : written) std::printf("%s\n", file.c_str());
}

}  // namespace diefill::app
