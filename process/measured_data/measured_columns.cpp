#include "process/measured_data/measured_columns.h"

#include <algorithm>
#include <cmath>

#include "process/input/csv_file.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/deviations.h"
#include "process/measured_data/written_comparison.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLargest = 16U << 20U;  // bytes of a CSV

[[noreturn]] void refuse_without_unit(const std::string& cell, const std::string& where) {
  throw SceneError(
      where + ": column \"" + one_line(cell) +
      "\" has no unit; write one after the name, as in \"mass [g]\", or \"[1]\" for plain numbers");
}

/// "mass [g]" as name and unit.
MeasuredColumn column_of(const std::string& cell, const std::string& where) {
  const CsvHeading heading = csv_heading(cell);
  const bool bracket = cell.find_first_of("[(") != std::string::npos;
  // Words behind a blank may be of the name, as in "solid fraction".
  if (heading.unit.empty() || (!bracket && !has_same_dimension(heading.unit, heading.unit)))
    refuse_without_unit(cell, where);
  MeasuredColumn column{heading.name, heading.unit, {}, where};
  try {
    unit_factor(column.unit, column.unit);
  } catch (const UnitError& error) {
    throw SceneError(where + ": column \"" + one_line(cell) + "\": " + error.what());
  }
  return column;
}

CsvFile opened(const std::filesystem::path& file) {
  try {
    return {file, {"table of measurements", "but measurements are a CSV file", kLargest}};
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& reason) {
    throw SceneError(file.string() + ": " + reason.what());
  }
}

/// Of the heading that is the current line.
std::vector<std::string> names_in(const CsvFile& file) {
  std::vector<std::string> names;
  for (const std::string& cell : file.cells()) names.push_back(csv_heading(cell).name);
  return names;
}

/// Deviations that were not given are none, and empty in tables that the program writes.
void drop_unknown_deviations(MeasuredColumns& read) {
  std::erase_if(read.columns, [](const MeasuredColumn& column) {
    return is_deviation(column) && std::all_of(column.values.begin(), column.values.end(),
                                               [](double value) { return std::isnan(value); });
  });
}

/// Which cells of a line are the measurement.
struct Taken {
  std::vector<std::size_t> cells;
  bool written = false;  ///< the table is one of the program's own
};

/// Columns of the heading, which is the current line.
Taken take_columns(const CsvFile& file, MeasuredColumns& read,
                   const std::function<std::string(std::size_t count)>& expected) {
  const std::vector<std::string> all = names_in(file), meant = names_of_measurement(all);
  Taken taken;
  taken.written = is_written_comparison(all);
  for (std::size_t k = 0; k < meant.size(); ++k)
    if (!taken.written || !meant[k].empty()) taken.cells.push_back(k);
  if (const std::string instead = expected(taken.cells.size()); !instead.empty())
    throw SceneError(file.place() + ": found " + std::to_string(taken.cells.size()) + " columns, expected " +
                     instead);
  std::vector<std::string> names;
  for (const std::size_t k : taken.cells) {
    read.columns.push_back(column_of(file.cells()[k], file.place(k)));
    if (taken.written) read.columns.back().name = meant[k];
    names.push_back(read.columns.back().name);
  }
  file.refuse_twice(names);
  return taken;
}

}  // namespace

MeasuredColumns columns_in(const std::filesystem::path& path,
                           const std::function<std::string(std::size_t count)>& expected) {
  CsvFile file = opened(path);
  MeasuredColumns read;
  read.where = path.string();
  Taken taken;
  if (file.next()) taken = take_columns(file, read, expected);
  while (file.next()) {
    for (std::size_t n = 0; n < taken.cells.size(); ++n) {
      const std::size_t cell = taken.cells[n];
      const bool unknown = taken.written && file.cells()[cell].empty() && is_deviation(read.columns[n]);
      read.columns[n].values.push_back(unknown ? std::nan("") : file.number(cell));
    }
    read.lines.push_back(file.line());
  }
  if (read.lines.empty())
    throw SceneError(path.string() + ": found no measured values; give a heading and a line for each value");
  if (taken.written) drop_unknown_deviations(read);
  return read;
}

}  // namespace diefill::process
