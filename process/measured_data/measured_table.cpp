#include "process/measured_data/measured_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "process/input/named_file.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/deviations.h"
#include "process/measured_data/known_fields.h"
#include "process/measured_data/measured_columns.h"
#include "process/measured_data/places.h"

namespace diefill::process {
namespace {

/// Drops the repeated end of closed curves and maps. Throws SceneError for anything wrong with points and
/// deviations.
void clean(MeasuredTable& table) {
  drop_repeated_end(table);
  check_deviations(table);
  check_places(table);
}

/// One list of numbers with units, all turned into the unit of the first; `example` stands between the outer
/// quotes of its list.
MeasuredColumn column_from(TableReader& measurement, const std::string& key, const std::string& example) {
  MeasuredColumn column;
  column.name = key;
  column.where = measurement.where(key);
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
    measurement.reject(key, "expected measured values with their units, such as [\"" + example + "\"]");
  return column;
}

/// `place`: what the column under "at" is called.
MeasuredTable read_inline(TableReader& measurement, std::size_t places, const std::string& place) {
  const bool single = places == 0;
  if (places == 2) measurement.require("file", "\"map.csv\"");
  MeasuredTable table;
  if (!single) table.places.push_back(column_from(measurement, kUnnamedPlaces, "0.1 m/s\", \"0.2 m/s"));
  table.value = single ? column_from(measurement, "value", "12.1 g")
                       : column_from(measurement, "values", "12.1 g\", \"8.3 g");
  const std::string key = single ? "deviation" : "deviations";
  table.deviation = column_from(measurement, key, single ? "0.3 g" : "0.3 g\", \"0.2 g");
  if (table.deviation.values.size() == 1)
    table.deviation.values.resize(table.size(), table.deviation.values[0]);
  const auto count = [&](const std::string& name, const MeasuredColumn& column, std::size_t wanted) {
    if (column.values.size() != wanted)
      measurement.reject(name, "allowed: as many entries as \"" + std::string(single ? "value" : "values") +
                                   "\" has (" + std::to_string(wanted) + ")");
  };
  if (!single) count(kUnnamedPlaces, table.places[0], table.size());
  if (single) count("value", table.value, 1);
  count(key, table.deviation, table.size());
  convert_deviation(table.deviation, table.value);
  table.where = table.value.where;
  if (!single) table.places[0].name = place;
  clean(table);
  return table;
}

/// Place in place_names(); its size for other columns.
std::size_t rank_of(const MeasuredColumn& column) {
  const auto& names = place_names();
  return static_cast<std::size_t>(
      std::find_if(names.begin(), names.end(),
                   [&](const std::string& name) { return same_name(name, column.name); }) -
      names.begin());
}

/// Of columns that are no places: the one of values.
MeasuredColumn value_among(std::vector<MeasuredColumn> others, const std::string& where) {
  if (others.size() == 1) return std::move(others.front());
  if (others.empty()) throw SceneError(where + ": found no column of values, such as \"fill level [mm]\"");
  for (const MeasuredColumn& column : others)
    if (!possible_values(column.name))
      throw SceneError(column.where + ": column of places: " + not_among(column.name, place_names()));
  throw SceneError(others[1].where + ": found a second column of values, \"" + one_line(others[1].name) +
                   "\"; put each in a separate file");
}

/// Columns by what they are called.
MeasuredTable by_names(MeasuredColumns read) {
  MeasuredTable table;
  table.where = read.where;
  table.lines = std::move(read.lines);
  const auto deviation = taken_deviation(read.columns);
  std::vector<MeasuredColumn> others;
  for (MeasuredColumn& column : read.columns)
    (rank_of(column) < place_names().size() ? table.places : others).push_back(std::move(column));
  table.value = value_among(std::move(others), read.where);
  if (table.places.empty() || table.places.size() > 2)
    throw SceneError(table.value.where + ": found " + std::to_string(table.places.size()) +
                     " columns of places beside \"" + one_line(table.value.name) +
                     "\", expected one or two, such as \"azimuth [deg]\"");
  for (MeasuredColumn& place : table.places) place.name = place_names()[rank_of(place)];
  std::sort(table.places.begin(), table.places.end(),
            [](const auto& one, const auto& other) { return rank_of(one) < rank_of(other); });
  table.deviation = deviation.value_or(table.value);
  if (deviation) {
    convert_deviation(table.deviation, table.value);
    check_deviations(table);
  } else {
    table.deviation.values.assign(table.size(), std::numeric_limits<double>::quiet_NaN());
  }
  drop_repeated_end(table);
  check_places(table);
  return table;
}

/// A profile or map by the names of its columns, whatever its values are. With two columns more than
/// `places`, the last one holds deviations where none is called so.
MeasuredTable field_in(const std::filesystem::path& file, std::optional<std::size_t> places = {}) {
  MeasuredColumns read = columns_in(file, [](std::size_t count) {
    return count >= 2 && count <= 4
               ? ""
               : "2 to 4: one or two places, the value, and its standard deviation where "
                 "it is known, separated by commas";
  });
  const bool named = std::any_of(read.columns.begin(), read.columns.end(), is_deviation);
  if (places && !named && read.columns.size() == *places + 2) read.columns.back().name = "deviation";
  return by_names(std::move(read));
}

void refuse_values_beside_file(TableReader& measurement) {
  for (const char* key : {"value", "deviation", kUnnamedPlaces, "values", "deviations"})
    if (measurement.has(key)) measurement.reject(key, "\"file\" has the values; remove one of the two");
}

}  // namespace

std::string MeasuredTable::where_of(std::size_t point) const {
  return lines.empty() ? where + ": point " + std::to_string(point + 1)
                       : where + ':' + std::to_string(lines[point]);
}

MeasuredTable read_measured_csv(const std::filesystem::path& file, std::size_t places) {
  const std::string wanted = std::to_string(places + 2) + " (" + (places > 0 ? "places, " : "") +
                             "value, standard deviation), separated by commas";
  MeasuredColumns read =
      columns_in(file, [&](std::size_t count) { return count == places + 2 ? "" : wanted; });
  MeasuredTable table;
  table.where = read.where;
  table.lines = std::move(read.lines);
  if (auto deviation = taken_deviation(read.columns)) {
    table.deviation = std::move(*deviation);
  } else {
    table.deviation = std::move(read.columns.back());
    read.columns.pop_back();
  }
  table.value = std::move(read.columns.back());
  read.columns.pop_back();
  table.places = std::move(read.columns);
  convert_deviation(table.deviation, table.value);
  clean(table);
  return table;
}

MeasuredTable read_measured_field(const std::filesystem::path& file) {
  MeasuredTable table = field_in(file);
  const std::string& quantity = table.value.name;
  const bool profile = table.places.size() == 1;
  if (const auto possible = possible_values(quantity)) {
    refuse_impossible(table, *possible);
    refuse_other_places(table, profile ? places_of_profile(quantity) : places_of_map(quantity));
  } else if (!profile) {
    refuse_other_places(table, places_of_map(quantity));
    if (has_same_dimension(table.value.unit, "1")) refuse_impossible(table, possible_in_sections());
  }
  return table;
}

MeasuredTable read_measured(TableReader& measurement, std::size_t places) {
  // Values of a scene's key are no places round a ring, even where they are angles.
  if (!measurement.has("file"))
    return read_inline(measurement, places, measurement.text("over").value_or(kUnnamedPlaces));
  refuse_values_beside_file(measurement);
  return read_measured_csv(named_file(measurement, "file", "measured.csv"), places);
}

MeasuredTable read_measured_field(TableReader& measurement, std::size_t places) {
  if (!measurement.has("file")) return read_inline(measurement, places, kUnnamedPlaces);
  refuse_values_beside_file(measurement);
  MeasuredTable table = field_in(named_file(measurement, "file", "measured.csv"), places);
  if (table.places.size() != places)
    throw SceneError(table.where + ": found " + std::to_string(table.places.size()) +
                     " columns of places, expected " + std::to_string(places));
  if (std::isnan(table.deviation.values.front()))
    throw SceneError(table.where +
                     ": found no column of standard deviations; a calibration weights values by them: add "
                     "one, such as \"deviation [" +
                     table.value.unit + "]\"");
  return table;
}

}  // namespace diefill::process
