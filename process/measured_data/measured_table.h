// Measured values with their standard deviations: in the calibration file itself, or as a CSV with units in
// its header.
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
  std::string where;  ///< its heading, "file:line:column", or its key; begins messages
};

/// Columns of places (none for a single figure, one for a curve, two for a map), then values and deviations;
/// both of these have the same unit.
struct MeasuredTable {
  std::vector<MeasuredColumn> places;
  MeasuredColumn value, deviation;
  std::string where;       ///< its file, or its key; begins messages
  std::vector<int> lines;  ///< of the points in the file; empty: they stand under a key

  std::size_t size() const { return value.values.size(); }
  /// "file:line" of a point, or which point of the key it is.
  std::string where_of(std::size_t point) const;
};

/// What a column of places is called where nothing names it: under the key `at`.
inline constexpr const char* kUnnamedPlaces = "at";

/// Reads a CSV: a header such as `velocity [m/s], mass [g], deviation [g]`, then numbers; lines that begin
/// with # are comments. The column of deviations may stand anywhere where its name tells (is_deviation());
/// otherwise it is the last one.
/// Throws SceneError, in one line with file, line and column, for a missing unit, two columns of one name, a
/// wrong number of columns, a text that is no number, a deviation that is not above zero or not within a
/// factor of 1e9 of the largest value, points of a curve that are not in rising order, azimuths outside -360
/// to 720 deg, and places given twice (azimuths modulo 360 deg).
MeasuredTable read_measured_csv(const std::filesystem::path& file, std::size_t places);

/// Reads a profile or map whose columns say themselves what they are, in any order: one or two places as
/// place_names() lists them, the value, and its standard deviation where a name tells (is_deviation()), such
/// as `azimuth [deg], fill level [mm]`. Deviations that are not given are NaN. Throws as read_measured_csv(),
/// for other columns, and for values that the quantity cannot have.
MeasuredTable read_measured_field(const std::filesystem::path& file);

/// What a [[measurement]] says: `file` (a CSV); or `value` and `deviation`; or, for a curve, the lists `at`,
/// `values` and `deviations` (one deviation serves all values). Places are called as the key `over` says, and
/// are azimuths only where that is "azimuth". Throws SceneError.
MeasuredTable read_measured(TableReader& measurement, std::size_t places);

/// The same of a profile (one place) or map (two); its `file` is read as a field, and must have deviations.
MeasuredTable read_measured_field(TableReader& measurement, std::size_t places);

}  // namespace diefill::process
