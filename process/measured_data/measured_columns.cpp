#include "process/measured_data/measured_columns.h"

#include "process/input/csv_file.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"

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
  const std::size_t open = cell.rfind('[');
  if (open == std::string::npos || cell.back() != ']') refuse_without_unit(cell, where);
  MeasuredColumn column{trimmed_cell(cell.substr(0, open)),
                        trimmed_cell(cell.substr(open + 1, cell.size() - open - 2)),
                        {},
                        where};
  if (column.unit.empty()) refuse_without_unit(cell, where);
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

}  // namespace

MeasuredColumns columns_in(const std::filesystem::path& path,
                           const std::function<std::string(std::size_t count)>& expected) {
  CsvFile file = opened(path);
  MeasuredColumns read;
  read.where = path.string();
  if (file.next()) {
    std::vector<std::string> names;
    const std::size_t count = file.cells().size();
    if (const std::string instead = expected(count); !instead.empty())
      throw SceneError(file.place() + ": found " + std::to_string(count) + " columns, expected " + instead);
    for (std::size_t k = 0; k < count; ++k) {
      read.columns.push_back(column_of(file.cells()[k], file.place(k)));
      names.push_back(read.columns.back().name);
    }
    file.refuse_twice(names);
  }
  while (file.next()) {
    for (std::size_t k = 0; k < read.columns.size(); ++k) read.columns[k].values.push_back(file.number(k));
    read.lines.push_back(file.line());
  }
  if (read.lines.empty())
    throw SceneError(path.string() + ": found no measured values; give a heading and a line for each value");
  return read;
}

}  // namespace diefill::process
