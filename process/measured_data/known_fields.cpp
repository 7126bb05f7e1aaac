#include "process/measured_data/known_fields.h"

#include <array>
#include <cmath>
#include <string_view>

#include "process/input/nearest_key.h"
#include "process/input/numbers_apart.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"
#include "process/results/cavity_rows.h"

namespace diefill::process {
namespace {

struct Quantity {
  const char* name;
  const char* unit;
  double least, most;
};

// A heap above the rim may fill a sector of the cavity more than once; no die is deeper than 10 m.
constexpr std::array<Quantity, 4> kQuantities = {{{"fill level", "mm", 0, 1e4},
                                                  {"filled fraction", "1", 0, 2},
                                                  {"solid fraction", "1", 0, 1},
                                                  {"mean grain diameter", "mm", 0, 100}}};

constexpr const char* kOver = " over ";

/// Quantity and coordinate of the profiles that process/measure makes.
/// Those over x and y are the one along the travel of the shoe, for measurements in the scene's coordinates.
constexpr std::array<std::array<const char*, 2>, 9> kProfiles = {
    {{"fill level", "azimuth"},
     {"fill level", "distance along the shoe's travel"},
     {"fill level", "x"},
     {"fill level", "y"},
     {"filled fraction", "azimuth"},
     {"solid fraction", "height"},
     {"mean grain diameter", "height"},
     {"mean grain diameter", "azimuth"},
     {"mean grain diameter", "travel"}}};

/// "fill level" of "fill level over azimuth" and of "fill level, cavity 2".
std::string plain(const std::string& quantity) {
  return results::quantity_and_cavity(quantity.substr(0, quantity.find(kOver))).first;
}

std::string unit_of_place(const std::string& name) {
  return name == "azimuth" ? "deg" : "mm";
}

/// Such as `"deg" (azimuth) or "mm" (height)`: a unit for each kind of place.
std::string units_of_places(const std::vector<std::string>& places) {
  std::string text;
  for (const std::string& name : places) {
    const std::string unit = '"' + unit_of_place(name) + '"';
    if (text.find(unit) == std::string::npos) text += (text.empty() ? "" : " or ") + unit + " (" + name + ')';
  }
  return text;
}

}  // namespace

std::optional<PossibleValues> possible_values(const std::string& quantity) {
  for (const Quantity& known : kQuantities)
    if (same_name(known.name, plain(quantity))) return PossibleValues{known.unit, known.least, known.most};
  return std::nullopt;
}

PossibleValues possible_in_sections() {
  return *possible_values("solid fraction");
}

const std::vector<std::string>& place_names() {
  static const std::vector<std::string> names = {"azimuth", "x",          "y",
                                                 "z",       "height",     "distance along the shoe's travel",
                                                 "travel",  "first axis", "second axis"};
  return names;
}

std::vector<std::string> possible_profiles() {
  std::vector<std::string> names;
  for (const Quantity& quantity : kQuantities) names.emplace_back(quantity.name);
  for (const auto& [quantity, over] : kProfiles) names.push_back(std::string(quantity) + kOver + over);
  return names;
}

std::vector<std::string> possible_maps() {
  return {"solid fraction", "fill level"};
}

std::vector<std::string> places_of_profile(const std::string& quantity) {
  std::vector<std::string> places;
  const std::size_t at = quantity.find(kOver);
  for (const auto& [known, over] : kProfiles)
    if (same_name(known, plain(quantity)) &&
        (at == std::string::npos || same_name(over, quantity.substr(at + std::string_view(kOver).size()))))
      places.emplace_back(over);
  return places;
}

std::vector<std::string> places_of_map(const std::string& quantity) {
  if (same_name(quantity, "fill level")) return {"x", "y"};
  if (same_name(quantity, "solid fraction")) return {"azimuth", "height", "x", "y"};
  return {"x", "y", "z", "first axis", "second axis"};
}

void refuse_other_places(const MeasuredTable& table, const std::vector<std::string>& allowed) {
  for (const MeasuredColumn& place : table.places) {
    const bool named = place.name != kUnnamedPlaces;
    std::string unit;  // of the dimension that it must have
    for (const std::string& name : allowed)
      if (named ? same_name(name, place.name) : has_same_dimension(place.unit, unit_of_place(name)))
        unit = unit_of_place(name);
    if (unit.empty() && named)
      throw SceneError(place.where + ": places of " + one_line(table.value.name) + ": " +
                       not_among(place.name, allowed));
    if (unit.empty())
      throw SceneError(place.where + ": found places in \"" + one_line(place.unit) +
                       "\", allowed: a unit such as " + units_of_places(allowed));
    if (!has_same_dimension(place.unit, unit))
      throw SceneError(place.where + ": found places in \"" + one_line(place.unit) +
                       "\", allowed: a unit such as \"" + unit + '"');
  }
}

bool holds_azimuths(const MeasuredColumn& place) {
  return (same_name(place.name, "azimuth") || place.name == kUnnamedPlaces) &&
         has_same_dimension(place.unit, "deg");
}

double azimuth_in_circle(double azimuth) {
  constexpr double kCircle = 360, kSteps = 1e9;  // in a degree: 2 pi rad, converted, is 360 deg
  const double within = std::round(std::fmod(azimuth, kCircle) * kSteps) / kSteps;
  const double positive = within < 0 ? within + kCircle : within;
  return positive < kCircle ? positive : 0;
}

bool same_name(const std::string& one, const std::string& other) {
  return one.size() == other.size() && edit_distance(one, other) == 0;
}

void refuse_impossible(const MeasuredTable& table, const PossibleValues& possible) {
  double factor = 1;
  try {
    factor = unit_factor(table.value.unit, possible.unit);
  } catch (const UnitError& error) {
    throw SceneError(table.value.where + ": found \"" + one_line(table.value.name) + " [" + table.value.unit +
                     "]\": " + error.what());
  }
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double value = factor * table.value.values[k];
    if (value >= possible.least && value <= possible.most) continue;
    const double least = possible.least / factor, most = possible.most / factor;
    const std::string unit = table.value.unit == "1" ? "" : ' ' + table.value.unit;
    const auto [found, limit] = numbers_apart(table.value.values[k], value < possible.least ? least : most);
    const std::string allowed = std::isinf(possible.most)
                                    ? number_text(least) + unit + " or more"
                                    : number_text(least) + " to " + number_text(most) + unit;
    throw SceneError(table.where_of(k) + ": found " + one_line(table.value.name) + ' ' + found + unit +
                     ", allowed: " + allowed +
                     ", the range of possible values; check the number and its unit");
  }
}

std::string not_among(const std::string& found, const std::vector<std::string>& allowed) {
  std::string text = "found \"" + one_line(found) + "\", allowed: ";
  for (const std::string& word : allowed) text += (&word == &allowed.front() ? "\"" : ", \"") + word + '"';
  const auto meant = nearest_key(found, allowed);
  return text + (meant ? "; did you mean \"" + *meant + "\"?" : "");
}

}  // namespace diefill::process
