// Measured values with their standard deviations as they come from a plant: in the calibration file itself,
// or as a CSV with units in its header.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/input/table_reader.h"

namespace diefill::process {

/// One column, all numbers in its unit.
struct MeasuredColumn {
  std::string name, unit;
  std::vector<double> values;
};

/// Columns of places (none for a single figure, one for a curve, two for a map), then values and deviations;
/// both of these have the same unit.
struct MeasuredTable {
  std::vector<MeasuredColumn> places;
  MeasuredColumn value, deviation;

  std::size_t size() const { return value.values.size(); }
};

/// Reads a CSV: a header such as `velocity [m/s], mass [g], deviation [g]`, then numbers; lines that begin
/// with # are comments. Throws SceneError, in one line with file and line, for a missing unit, a wrong number
/// of columns, a text that is no number, and what check_measured refuses.
MeasuredTable read_measured_csv(const std::filesystem::path& file, std::size_t places);

/// Reads a profile or map that says itself what it is: one or two columns of places, the value, and the
/// standard deviation where the last column's name has "deviation" in it, such as
/// `azimuth [deg], fill level [mm]`. Deviations that are not given are NaN. Throws as read_measured_csv().
MeasuredTable read_measured_field(const std::filesystem::path& file);

/// What a [[measurement]] says: `file` (a CSV); or `value` and `deviation`; or, for a curve, the lists `at`,
/// `values` and `deviations` (one deviation serves all values). Throws SceneError.
MeasuredTable read_measured(TableReader& measurement, std::size_t places);

/// Throws SceneError for deviations that are not above zero, points of a curve that are not in rising order,
/// and places given twice. `where` begins each message; `line` of each point follows it where not empty.
void check_measured(const MeasuredTable& table, const std::string& where, const std::vector<int>& line);

}  // namespace diefill::process
