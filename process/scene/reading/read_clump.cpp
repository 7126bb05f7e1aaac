#include "process/scene/reading/read_clump.h"

#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "engine/powder/clump_union.h"
#include "process/input/text_file.h"

namespace diefill::process {
namespace {

using engine::ClumpSphere;

constexpr QuantityRule kPlace = {Dimension::length, "0.1 mm", "-100 mm", "100 mm"};
constexpr QuantityRule kRadius = {Dimension::length, "0.1 mm", "0 mm", "10 mm", true};
/// Of one grain: its laws and places are computed for each.
constexpr std::size_t kMostSpheres = 64;

std::vector<ClumpSphere> spheres_in_scene(TableReader& table) {
  std::vector<ClumpSphere> spheres;
  for (TableReader& entry : table.tables("spheres")) {
    entry.require("centre", "[\"0.1 mm\", \"0 mm\", \"0 mm\"]");
    ClumpSphere sphere;
    sphere.centre = *entry.point("centre", kPlace);
    sphere.radius = entry.required_quantity("radius", kRadius);
    entry.finish();
    spheres.push_back(sphere);
  }
  return spheres;
}

/// One row of numbers; refused where it has not four.
ClumpSphere sphere_of_row(const std::string& row, const std::string& where, double metres_per_unit) {
  std::array<double, 4> numbers;
  std::istringstream text(row);
  std::string cell;
  std::size_t count = 0;
  while (std::getline(text, cell, ',')) {
    const std::size_t first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t\r");
    double value = 0;
    const char* end = first == std::string::npos ? nullptr : cell.data() + last + 1;
    if (count >= 4 || end == nullptr || std::from_chars(cell.data() + first, end, value).ptr != end)
      throw SceneError(where + ": expected x, y, z and radius, four numbers with commas between; found \"" +
                       row + '"');
    numbers[count++] = value * metres_per_unit;
  }
  if (count != 4 || !(numbers[3] > 0))
    throw SceneError(where +
                     ": expected x, y, z and a radius above 0, four numbers with commas between; "
                     "found \"" +
                     row + '"');
  return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

/// m, of the unit in a header such as "x [mm], y [mm], z [mm], radius [mm]".
double unit_of_header(const std::string& header, const std::string& where) {
  for (const auto& [unit, metres] : {std::pair{"[mm]", 1e-3}, {"[um]", 1e-6}, {"[m]", 1.0}}) {
    std::size_t count = 0;
    for (std::size_t at = header.find(unit); at != std::string::npos; at = header.find(unit, at + 1)) ++count;
    if (count == 4) return metres;
  }
  throw SceneError(where +
                   ": the first line must name four columns of one length unit, such as \"x [mm], y "
                   "[mm], z [mm], radius [mm]\"; found \"" +
                   header + '"');
}

std::vector<ClumpSphere> spheres_in_file(TableReader& table) {
  const std::filesystem::path given = table.required_text("spheres_file", "grain.csv");
  const auto file = given.is_absolute() ? given : table.file().parent_path() / given;
  constexpr std::size_t kLargest = 1 << 20;
  std::string content;
  try {
    content = load_text_file(
        file, {"file of spheres", "one line of columns, and a line for each sphere", kLargest});
  } catch (const std::runtime_error& error) {
    table.reject("spheres_file", error.what());
  }
  std::istringstream text(content);
  std::string line;
  std::vector<ClumpSphere> spheres;
  double metres_per_unit = 0;
  for (int number = 1; std::getline(text, line); ++number) {
    const std::string where = file.string() + ":" + std::to_string(number);
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (metres_per_unit == 0)
      metres_per_unit = unit_of_header(line, where);
    else
      spheres.push_back(sphere_of_row(line, where, metres_per_unit));
  }
  return spheres;
}

}  // namespace

void read_clump(TableReader& table, PowderSpec& powder, double density) {
  const bool in_scene = table.has("spheres"), in_file = table.has("spheres_file");
  if (!in_scene && !in_file) return;
  const std::string key = in_scene ? "spheres" : "spheres_file";
  if (in_scene && in_file)
    table.reject("spheres_file", "powder.spheres gives the clump already; remove one of the two");
  for (const char* other : {"model", "sphere_radius"})
    if (table.has(other))
      table.reject(other, "powder." + key + " gives the shape of the grain; remove the key");
  const auto spheres = in_scene ? spheres_in_scene(table) : spheres_in_file(table);
  if (spheres.empty() || spheres.size() > kMostSpheres)
    table.reject(key,
                 std::to_string(spheres.size()) + " spheres, allowed: 1 to " + std::to_string(kMostSpheres));
  constexpr double kUnit = 1;  // kg/m^3
  const double volume = engine::grain_of_union(spheres, kUnit).solid_volume;
  const auto shape = engine::grain_of_union(spheres, density > 0 ? density : powder.grain_mass / volume);
  powder.model = GrainModel::clump;
  powder.sphere_radius = shape.sphere_radius;
  powder.grain_mass = shape.mass;
  powder.rolling_friction = 0;
  powder.clump = std::make_shared<const engine::GrainShape>(shape);
}

}  // namespace diefill::process
