#include "process/measured_data/places.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/known_fields.h"

namespace diefill::process {
namespace {

constexpr double kRounding = 1e-9;  // deg

/// Throws SceneError for an azimuth beyond two turns.
void check_azimuth(double azimuth, const std::string& where) {
  constexpr double kLeast = -360, kMost = 720;  // deg
  if (azimuth >= kLeast - kRounding && azimuth <= kMost + kRounding) return;
  throw SceneError(where + ": found azimuth " + number_text(azimuth) + " deg, allowed: " +
                   number_text(kLeast) + " to " + number_text(kMost) + " deg; check the number and its unit");
}

/// Deg of a column of azimuths.
std::vector<double> degrees_of(const MeasuredColumn& column) {
  const double factor = unit_factor(column.unit, "deg");
  std::vector<double> degrees = column.values;
  for (double& azimuth : degrees) azimuth *= factor;
  return degrees;
}

/// Whether two points differ in the column `azimuths` alone.
bool repeats(const MeasuredTable& table, const MeasuredColumn& azimuths, std::size_t one, std::size_t other) {
  const auto same = [&](const MeasuredColumn& column) {
    return &column == &azimuths || column.values[one] == column.values[other];
  };
  return table.value.values[one] == table.value.values[other] &&
         std::all_of(table.places.begin(), table.places.end(), same);
}

/// Where a point's place stands: the line of the file, or its entry of the key.
std::string where_of_place(const MeasuredTable& table, std::size_t point) {
  if (!table.lines.empty() || table.places.empty()) return table.where_of(point);
  return table.places[0].where + ": point " + std::to_string(point + 1);
}

void remove_point(MeasuredTable& table, std::size_t point) {
  const auto at = static_cast<std::ptrdiff_t>(point);
  const auto shorten = [&](auto& values) {
    if (point < values.size()) values.erase(values.begin() + at);
  };
  for (MeasuredColumn& place : table.places) shorten(place.values);
  shorten(table.value.values);
  shorten(table.deviation.values);
  shorten(table.lines);
}

}  // namespace

void drop_repeated_end(MeasuredTable& table) {
  const auto azimuths = std::find_if(table.places.begin(), table.places.end(), holds_azimuths);
  if (azimuths == table.places.end() || table.size() == 0) return;
  const std::vector<double> degrees = degrees_of(*azimuths);
  const auto [first, last] = std::minmax_element(degrees.begin(), degrees.end());
  if (std::abs(*last - *first - 360) > kRounding) return;
  std::vector<std::size_t> begins, repeated;
  for (std::size_t k = 0; k < degrees.size(); ++k)
    if (degrees[k] < *first + kRounding) begins.push_back(k);
  for (std::size_t k = degrees.size(); k-- > 0;)
    if (degrees[k] > *last - kRounding && std::any_of(begins.begin(), begins.end(), [&](std::size_t begin) {
          return repeats(table, *azimuths, begin, k);
        }))
      repeated.push_back(k);
  for (const std::size_t point : repeated) remove_point(table, point);
}

void check_places(const MeasuredTable& table) {
  std::set<std::vector<double>> seen;
  for (std::size_t k = 0; k < table.size(); ++k) {
    std::vector<double> place;
    bool round = false;
    for (const MeasuredColumn& column : table.places) {
      place.push_back(column.values[k]);
      if (!holds_azimuths(column)) continue;
      const double azimuth = unit_factor(column.unit, "deg") * place.back();
      check_azimuth(azimuth, where_of_place(table, k));
      place.back() = azimuth_in_circle(azimuth);
      round = true;
    }
    if (!place.empty() && !seen.insert(place).second)
      throw SceneError(where_of_place(table, k) + ": this place is given twice" +
                       (round ? " (azimuths count modulo 360 deg)" : "") +
                       "; give each place once, with the mean of its values");
    if (place.size() != 1 || k == 0) continue;
    const double here = table.places[0].values[k], before = table.places[0].values[k - 1];
    if (here < before)
      throw SceneError(where_of_place(table, k) + ": " + number_text(here) + " follows " +
                       number_text(before) + "; sort the points in rising order");
  }
}

}  // namespace diefill::process
