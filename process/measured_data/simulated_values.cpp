#include "process/measured_data/simulated_values.h"

#include <algorithm>

#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/known_fields.h"
#include "process/measured_data/profile_names.h"
#include "process/results/cavity_rows.h"
#include "process/results/field_value.h"

namespace diefill::process {
namespace {

double factor_or_throw(const std::string& from, const std::string& to, const std::string& where) {
  try {
    return unit_factor(from, to);
  } catch (const UnitError& error) {
    throw SceneError(where + ": " + error.what());
  }
}

/// The available words, and the one that was probably meant.
std::string listed(const std::vector<std::string>& words, const std::string& wanted) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "\"" : ", \"") + word + '"';
  const auto meant = nearest_key(wanted, words);
  return (text.empty() ? "none" : text) + (meant ? "; did you mean \"" + *meant + "\"?" : "");
}

/// Maps and sections by name.
std::vector<std::pair<std::string, const results::Field2D*>> fields_of(const results::FillResult& result) {
  std::vector<std::pair<std::string, const results::Field2D*>> fields;
  for (const auto& map : result.maps) fields.emplace_back(map.quantity, &map);
  for (const auto& section : result.sections) fields.emplace_back(section.plane.name, &section.field);
  return fields;
}

/// Profiles of that quantity ("fill level", or "fill level over azimuth").
std::vector<const results::Profile*> profiles_called(const results::FillResult& result,
                                                     const std::string& quantity, const std::string& where) {
  std::vector<std::string> known;
  std::vector<const results::Profile*> found;
  for (const results::Profile& profile : result.profiles) {
    known.push_back(profile.quantity + " over " + profile.x_name);
    const auto names = names_of(profile);
    const auto same = [&](const std::string& name) { return same_name(name, quantity); };
    if (std::any_of(names.begin(), names.end(), same)) found.push_back(&profile);
  }
  if (found.empty())
    throw SceneError(where + ": the result has no profile \"" + quantity + "\"; it has " +
                     listed(known, quantity));
  return found;
}

/// The profile that runs along the places, by their name, or by their unit where they have no name.
const results::Profile& profile_for(const results::FillResult& result, const std::string& quantity,
                                    const MeasuredColumn& place, const std::string& where) {
  std::vector<std::string> over;
  const results::Profile* chosen = nullptr;
  for (const results::Profile* profile : profiles_called(result, quantity, where)) {
    over.push_back(profile->x_name + " [" + profile->x_unit + ']');
    const bool travels = runs_along_travel(*profile) && distance_along_travel(place.name, 0, result.cavity);
    const bool meant = place.name == kUnnamedPlaces ? has_same_dimension(place.unit, profile->x_unit)
                                                    : travels || same_name(place.name, profile->x_name);
    if (!meant) continue;
    if (chosen != nullptr)
      throw SceneError(where + ": the result has \"" + quantity + "\" over " + listed(over, "") +
                       "; write which, such as \"" + chosen->quantity + " over " + chosen->x_name + '"');
    chosen = profile;
  }
  if (chosen != nullptr) return *chosen;
  throw SceneError(place.where + ": found places as \"" + place.name + " [" + place.unit + "]\", but the " +
                   quantity + " of the result runs over " + listed(over, place.name));
}

/// The cavity that the profile is of.
const results::CavityState& cavity_of(const results::Profile& profile, const results::FillResult& result) {
  const int number = results::quantity_and_cavity(profile.quantity).second;
  return number < 2 ? result.cavity : result.other_cavities.at(static_cast<std::size_t>(number) - 2);
}

/// The measured place (in the profile's unit) as the profile counts it.
double place_on(const results::Profile& profile, const MeasuredColumn& place, double at,
                const results::FillResult& result) {
  if (!runs_along_travel(profile)) return at;
  const double metres = unit_factor(profile.x_unit, "m");
  const auto distance = distance_along_travel(place.name, metres * at, cavity_of(profile, result));
  return distance ? *distance / metres : at;
}

/// The measured coordinate of that name.
const MeasuredColumn& column_called(const std::string& name, const results::Field2D& field,
                                    const MeasuredTable& data) {
  for (const MeasuredColumn& column : data.places)
    if (same_name(column.name, name)) return column;
  throw SceneError(data.where + ": found places as \"" + data.places[0].name + "\" and \"" +
                   data.places[1].name + "\", but the " + field.quantity + " of the result runs over \"" +
                   field.first_name + " [" + field.first_unit + "]\" and \"" + field.second_name + " [" +
                   field.second_unit + "]\"");
}

/// Of a map's or section's values.
std::string unit_of(const results::Field2D& field) {
  const auto possible = possible_values(field.quantity);
  return possible ? possible->unit : "1";
}

}  // namespace

std::vector<double> profile_values(const results::FillResult& result, const std::string& quantity,
                                   const MeasuredTable& data, const std::string& where) {
  const MeasuredColumn& place = data.places[0];
  const results::Profile& profile = profile_for(result, quantity, place, where);
  const double along = factor_or_throw(place.unit, profile.x_unit, place.where),
               factor = factor_or_throw(profile.unit, data.value.unit, data.value.where);
  std::vector<double> values;
  for (const double x : place.values)
    values.push_back(factor * results::value_at(profile, place_on(profile, place, along * x, result)));
  return values;
}

std::vector<double> map_values(const results::FillResult& result, const std::string& quantity,
                               const MeasuredTable& data, const std::string& where) {
  std::vector<std::string> known;
  for (const auto& [name, field] : fields_of(result)) {
    known.push_back(name);
    if (!same_name(name, quantity)) continue;
    const MeasuredColumn &first = column_called(field->first_name, *field, data),
                         &second = column_called(field->second_name, *field, data);
    const double along_first = factor_or_throw(first.unit, field->first_unit, first.where),
                 along_second = factor_or_throw(second.unit, field->second_unit, second.where),
                 factor = factor_or_throw(unit_of(*field), data.value.unit, data.value.where);
    std::vector<double> values;
    for (std::size_t k = 0; k < data.size(); ++k)
      values.push_back(
          factor * results::value_at(*field, along_first * first.values[k], along_second * second.values[k]));
    return values;
  }
  throw SceneError(where + ": the result has no map or section \"" + quantity + "\"; it has " +
                   listed(known, quantity));
}

}  // namespace diefill::process
