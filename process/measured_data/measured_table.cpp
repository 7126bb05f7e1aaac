#include "process/measured_data/measured_table.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

#include "process/input/csv_cells.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/text_file.h"
#include "process/input/unit_conversion.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLargest = 16U << 20U;  // bytes of a CSV

std::vector<std::string> cells_of(const std::string& line) {
  const char separator = line.find(';') != std::string::npos ? ';' : ',';
  return csv_cells(line, separator);
}

/// "mass [g]" as name and unit.
MeasuredColumn column_of(const std::string& cell, const std::string& where) {
  const std::size_t open = cell.rfind('[');
  if (open == std::string::npos || cell.back() != ']')
    throw SceneError(
        where + ": column \"" + one_line(cell) +
        "\" has no unit; write one behind the name, as in \"mass [g]\", or \"[1]\" for plain numbers");
  MeasuredColumn column{
      trimmed_cell(cell.substr(0, open)), trimmed_cell(cell.substr(open + 1, cell.size() - open - 2)), {}};
  try {
    unit_factor(column.unit, column.unit);
  } catch (const UnitError& error) {
    throw SceneError(where + ": column \"" + one_line(cell) + "\": " + error.what());
  }
  return column;
}

double number_in(const std::string& cell, const std::string& where) {
  double value = 0;
  const char* const end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
    throw SceneError(where + ": found \"" + one_line(cell) + "\", expected a number with a decimal point");
  return value;
}

/// Into the unit of the values.
void convert(MeasuredColumn& deviation, const MeasuredColumn& value, const std::string& where) {
  try {
    const double factor = unit_factor(deviation.unit, value.unit);
    for (double& number : deviation.values) number *= factor;
    deviation.unit = value.unit;
  } catch (const UnitError& error) {
    throw SceneError(where + ": deviation in \"" + deviation.unit + "\", value in \"" + value.unit +
                     "\": " + error.what() + "; give both with their unit");
  }
}

MeasuredTable table_of(std::vector<MeasuredColumn> columns) {
  MeasuredTable table;
  table.deviation = std::move(columns.back());
  columns.pop_back();
  table.value = std::move(columns.back());
  columns.pop_back();
  table.places = std::move(columns);
  return table;
}

/// One list of numbers with units, all turned into the unit of the first.
MeasuredColumn column_from(TableReader& measurement, const std::string& key, const std::string& example) {
  MeasuredColumn column;
  column.name = key;
  for (const std::string& text : measurement.texts(key, example)) {
    try {
      const NumberWithUnit read = number_with_unit(text);
      if (column.values.empty()) column.unit = read.unit;
      column.values.push_back(read.number * unit_factor(read.unit, column.unit));
    } catch (const UnitError& error) {
      throw SceneError(measurement.where(key) + ": found \"" + one_line(text) + "\": " + error.what());
    }
  }
  if (column.values.empty())
    measurement.reject(key, "expected measured values with their units, such as " + example);
  return column;
}

MeasuredTable read_inline(TableReader& measurement, std::size_t places) {
  const bool single = places == 0;
  if (places == 2) measurement.require("file", "\"map.csv\"");
  MeasuredTable table;
  if (!single) table.places.push_back(column_from(measurement, "at", "[\"0.1 m/s\", \"0.2 m/s\"]"));
  table.value = single ? column_from(measurement, "value", "\"12.1 g\"")
                       : column_from(measurement, "values", "[\"12.1 g\", \"8.3 g\"]");
  const std::string key = single ? "deviation" : "deviations";
  table.deviation = column_from(measurement, key, single ? "\"0.3 g\"" : "[\"0.3 g\", \"0.2 g\"]");
  if (table.deviation.values.size() == 1)
    table.deviation.values.resize(table.size(), table.deviation.values[0]);
  const auto count = [&](const std::string& name, const MeasuredColumn& column, std::size_t wanted) {
    if (column.values.size() != wanted)
      measurement.reject(name, "allowed: as many entries as \"" + std::string(single ? "value" : "values") +
                                   "\" has (" + std::to_string(wanted) + ")");
  };
  if (!single) count("at", table.places[0], table.size());
  if (single) count("value", table.value, 1);
  count(key, table.deviation, table.size());
  convert(table.deviation, table.value, measurement.where(key));
  check_measured(table, measurement.where(single ? "value" : "values"), {});
  return table;
}

/// A CSV of numbers.
struct Columns {
  std::vector<MeasuredColumn> columns;
  std::vector<int> lines;  ///< of each row
};

/// `expected` says what a number of columns should be instead; empty: it is right.
Columns columns_in(const std::filesystem::path& file,
                   const std::function<std::string(std::size_t)>& expected) {
  std::string text;
  try {
    text = load_text_file(file, {"table of measurements", "but measurements are a CSV file", kLargest});
  } catch (const std::runtime_error& reason) {
    throw SceneError(file.string() + ": " + reason.what());
  }
  std::istringstream lines(text);
  Columns read;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (trimmed_cell(line).empty() || trimmed_cell(line).front() == '#') continue;
    const std::string where = file.string() + ':' + std::to_string(number);
    const auto cells = cells_of(line);
    const bool header = read.columns.empty();
    const std::string instead = header ? expected(cells.size())
                                : cells.size() == read.columns.size()
                                    ? ""
                                    : std::to_string(read.columns.size()) + ", as the header has";
    if (!instead.empty())
      throw SceneError(where + ": found " + std::to_string(cells.size()) + " columns, expected " + instead);
    if (header) {
      for (const auto& cell : cells) read.columns.push_back(column_of(cell, where));
      continue;
    }
    for (std::size_t k = 0; k < cells.size(); ++k)
      read.columns[k].values.push_back(number_in(cells[k], where));
    read.lines.push_back(number);
  }
  if (read.lines.empty()) throw SceneError(file.string() + ": found no measured values");
  return read;
}

MeasuredTable checked(MeasuredTable table, const std::filesystem::path& file, const std::vector<int>& lines) {
  convert(table.deviation, table.value, file.string());
  check_measured(table, file.string(), lines);
  return table;
}

}  // namespace

void check_measured(const MeasuredTable& table, const std::string& where, const std::vector<int>& line) {
  const auto at = [&](std::size_t k) {
    return line.empty() ? where + ": point " + std::to_string(k + 1) : where + ':' + std::to_string(line[k]);
  };
  std::set<std::vector<double>> seen;
  for (std::size_t k = 0; k < table.size(); ++k) {
    if (!(table.deviation.values[k] > 0))
      throw SceneError(at(k) + ": the standard deviation is " + number_text(table.deviation.values[k]) +
                       ", allowed: more than 0; give what repeated measurements scatter by");
    std::vector<double> place;
    for (const MeasuredColumn& column : table.places) place.push_back(column.values[k]);
    if (!place.empty() && !seen.insert(place).second)
      throw SceneError(at(k) +
                       ": this place is given twice; give each place once, with the mean of its values");
    if (place.size() == 1 && k > 0 && place[0] < table.places[0].values[k - 1])
      throw SceneError(at(k) + ": " + number_text(place[0]) + " follows " +
                       number_text(table.places[0].values[k - 1]) + "; sort the points in rising order");
  }
}

MeasuredTable read_measured_csv(const std::filesystem::path& file, std::size_t places) {
  const std::string wanted = std::to_string(places + 2) + " (" + (places > 0 ? "places, " : "") +
                             "value, standard deviation), separated by commas";
  Columns columns = columns_in(file, [&](std::size_t count) { return count == places + 2 ? "" : wanted; });
  return checked(table_of(std::move(columns.columns)), file, columns.lines);
}

MeasuredTable read_measured_field(const std::filesystem::path& file) {
  Columns columns = columns_in(file, [](std::size_t count) {
    return count >= 2 && count <= 4
               ? ""
               : "2 to 4: one or two places, the value, and its standard deviation where "
                 "it is known, separated by commas";
  });
  const bool with_deviation = columns.columns.back().name.find("deviation") != std::string::npos;
  if (columns.columns.size() == 4 && !with_deviation)
    throw SceneError(file.string() + ": found 4 columns, the last of them \"" + columns.columns.back().name +
                     "\", expected \"deviation\"");
  if (columns.columns.size() == 2 && with_deviation)
    throw SceneError(file.string() +
                     ": found a value with its deviation, expected a place in the first column");
  if (with_deviation) return checked(table_of(std::move(columns.columns)), file, columns.lines);
  MeasuredColumn unknown = columns.columns.back();
  unknown.values.assign(unknown.values.size(), 1);
  columns.columns.push_back(std::move(unknown));
  MeasuredTable table = checked(table_of(std::move(columns.columns)), file, columns.lines);
  table.deviation.values.assign(table.size(), std::numeric_limits<double>::quiet_NaN());
  return table;
}

MeasuredTable read_measured(TableReader& measurement, std::size_t places) {
  const auto name = measurement.text("file");
  if (!name) return read_inline(measurement, places);
  for (const char* key : {"value", "deviation", "at", "values", "deviations"})
    if (measurement.has(key)) measurement.reject(key, "\"file\" has the values; remove one of the two");
  return read_measured_csv(measurement.file().parent_path() / *name, places);
}

}  // namespace diefill::process
