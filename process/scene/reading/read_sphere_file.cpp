#include "process/scene/reading/read_sphere_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "process/input/csv_file.h"
#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"

namespace diefill::process {
namespace {

using engine::ClumpSphere;

const std::vector<std::string> kNames = {"x", "y", "z", "radius"};
constexpr std::size_t kRadius = 3;
constexpr double kSmallestRadius = 1e-9;  // m

/// A column of the file: which of kNames it is.
struct Column {
  std::size_t quantity = 0;
  std::string unit;
  double metres = 0;  ///< of one of its unit
};

double metres_per(const std::string& unit, const std::string& place) {
  if (unit == "mm") return 1e-3;
  if (unit == "um") return 1e-6;
  try {
    return unit_factor(unit, "m");
  } catch (const UnitError&) {
    throw SceneError(place + ": found unit \"" + one_line(unit) +
                     "\", allowed: a unit of length, such as mm");
  }
}

Column column_of(const std::string& cell, const std::string& place) {
  static const std::string allowed =
      "allowed: x, y, z and radius, each with its unit of length, such as \"x [mm], y [mm], z [mm], radius "
      "[mm]\"";
  const CsvHeading heading = csv_heading(cell);
  const auto found = std::find(kNames.begin(), kNames.end(), heading.name);
  if (found == kNames.end()) {
    const auto meant = nearest_key(heading.name, kNames);
    throw SceneError(place + ": found column \"" + one_line(cell) + '"' +
                     (meant ? ", did you mean \"" + *meant + "\"? " : ", ") + allowed);
  }
  if (heading.unit.empty())
    throw SceneError(place + ": found column \"" + one_line(cell) + "\" without a unit, " + allowed);
  return {static_cast<std::size_t>(found - kNames.begin()), heading.unit, metres_per(heading.unit, place)};
}

std::vector<Column> columns_of(const CsvFile& file) {
  std::vector<Column> columns;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < file.cells().size(); ++k) {
    columns.push_back(column_of(file.cells()[k], file.place(k)));
    names.push_back(kNames[columns.back().quantity]);
  }
  file.refuse_twice(names);
  for (const std::string& name : kNames)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw SceneError(file.place() + ": found no column " + name +
                       "; expected x, y, z and radius, such as \"x [mm], y [mm], z [mm], radius [mm]\"");
  return columns;
}

/// A number of the file in m, within its limits.
double length_in(const CsvFile& file, std::size_t cell, const Column& column, const SphereLimits& limits) {
  const std::string& name = kNames[column.quantity];
  const double value = file.number(cell, name) * column.metres;
  const bool radius = column.quantity == kRadius;
  const double least = radius ? kSmallestRadius : -limits.farthest,
               most = radius ? limits.largest_radius : limits.farthest;
  if (value >= least && value <= most) return value;
  throw SceneError(file.place(cell) + ": column " + name + ": found " + one_line(file.cells()[cell]) + ' ' +
                   column.unit + ", allowed: " + number_text(least / column.metres) + " to " +
                   number_text(most / column.metres) + ' ' + column.unit + "; check number and unit");
}

ClumpSphere sphere_of_row(const CsvFile& file, const std::vector<Column>& columns,
                          const SphereLimits& limits) {
  std::array<double, 4> numbers{};
  for (std::size_t k = 0; k < columns.size(); ++k)
    numbers[columns[k].quantity] = length_in(file, k, columns[k], limits);
  return {{numbers[0], numbers[1], numbers[2]}, numbers[kRadius]};
}

}  // namespace

SphereRows spheres_in_file(const std::filesystem::path& path, const SphereLimits& limits) {
  CsvFile file(path, {"file of spheres", "one line of columns, and a line for each sphere", limits.bytes});
  SphereRows rows;
  if (!file.next()) return rows;
  const std::vector<Column> columns = columns_of(file);
  while (file.next()) {
    rows.spheres.push_back(sphere_of_row(file, columns, limits));
    rows.lines.push_back(file.line());
  }
  return rows;
}

SphereRows read_sphere_file(TableReader& table, const std::string& key, const SphereLimits& limits) {
  const std::filesystem::path given = table.required_text(key, "grains.csv");
  try {
    return spheres_in_file(given.is_absolute() ? given : table.file().parent_path() / given, limits);
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& error) {
    table.reject(key, error.what());
  }
}

}  // namespace diefill::process
