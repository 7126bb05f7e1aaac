#include "process/scene/reading/read_sphere_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "process/input/scene_error.h"
#include "process/input/text_file.h"

namespace diefill::process {
namespace {

using engine::ClumpSphere;

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

}  // namespace

std::vector<ClumpSphere> spheres_in_file(const std::filesystem::path& file, std::size_t largest) {
  // As much memory as the file needs, not as the largest would.
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  const std::size_t most = error ? largest : std::min<std::size_t>(largest, size);
  std::istringstream text(
      load_text_file(file, {"file of spheres", "one line of columns, and a line for each sphere", most}));
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

std::vector<ClumpSphere> read_sphere_file(TableReader& table, const std::string& key, std::size_t largest) {
  const std::filesystem::path given = table.required_text(key, "grains.csv");
  try {
    return spheres_in_file(given.is_absolute() ? given : table.file().parent_path() / given, largest);
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& error) {
    table.reject(key, error.what());
  }
}

}  // namespace diefill::process
