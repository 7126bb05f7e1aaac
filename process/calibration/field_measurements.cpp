// Profiles and maps of a scene's result against measured ones.
#include <algorithm>
#include <cmath>

#include "process/calibration/measurement.h"
#include "process/input/scene_error.h"
#include "process/measure/fields/measured_fields.h"
#include "process/measured_data/known_fields.h"
#include "process/measured_data/simulated_values.h"
#include "process/results/cavity_rows.h"

namespace diefill::process::calibration {
namespace {

using OfResult = std::vector<double> (*)(const results::FillResult&, const std::string&, const MeasuredTable&,
                                         const std::string&);

/// What may stand under `profile` or `map`, and the places that it runs over.
struct KnownField {
  std::vector<std::string> names, places;
  PossibleValues possible;
};

/// A sector without powder has no grain to give its level: it is filled to the floor.
std::vector<double> values_of_profile(const results::FillResult& result, const std::string& quantity,
                                      const MeasuredTable& data, const std::string& where) {
  results::FillResult levelled;
  levelled.profiles = result.profiles;
  levelled.cavity = result.cavity;
  levelled.other_cavities = result.other_cavities;
  for (results::Profile& profile : levelled.profiles) {
    if (!same_name(results::quantity_and_cavity(profile.quantity).first, "fill level")) continue;
    for (double& level : profile.y)
      if (std::isnan(level)) level = 0;
  }
  return profile_values(levelled, quantity, data, where);
}

/// A column of the file that is called like another quantity holds something else.
void refuse_other_values(const MeasuredTable& data, const std::string& quantity) {
  if (data.lines.empty() || !possible_values(data.value.name)) return;
  const auto base_name = [](const std::string& name) { return name.substr(0, name.find(" over ")); };
  if (same_name(base_name(data.value.name), base_name(results::quantity_and_cavity(quantity).first))) return;
  throw SceneError(data.value.where + ": column of values: " + not_among(data.value.name, {quantity}));
}

Measurement read_field(TableReader& table, const MeasurementRun& run, const std::string& quantity,
                       const std::string& key, const KnownField& known, OfResult of_result) {
  const std::string where = table.where(key);
  if (known.places.empty()) throw SceneError(where + ": " + not_among(quantity, known.names));
  Measurement measurement;
  measurement.quantity = quantity;
  measurement.runs = {run};
  measurement.data = read_measured_field(table, key == "profile" ? 1 : 2);
  refuse_other_values(measurement.data, quantity);
  refuse_other_places(measurement.data, known.places);
  refuse_impossible(measurement.data, known.possible);
  measurement.simulated = [=, data = measurement.data](const std::vector<FinishedRun>& runs) {
    return of_result(*runs.front().result, quantity, data, where);
  };
  return measurement;
}

/// Names of the scene's sections; the one that results have where it asks for none.
std::vector<std::string> sections_of(const MeasurementRun& run) {
  std::vector<std::string> names;
  for (const SectionSpec& section : parse_scene(run.text, run.file).measure.sections)
    names.push_back(section.name);
  return names.empty() ? std::vector<std::string>{kDefaultSection} : names;
}

}  // namespace

Measurement read_profile_measurement(TableReader& table, const MeasurementContext& context) {
  const std::string quantity = table.required_text("profile", "fill level");
  const MeasurementRun run = run_of_scene(table, context);
  const auto possible = possible_values(quantity);
  return read_field(
      table, run, quantity, "profile",
      {possible_profiles(), places_of_profile(quantity), possible.value_or(PossibleValues{"1", 0, 0})},
      values_of_profile);
}

Measurement read_map_measurement(TableReader& table, const MeasurementContext& context) {
  const std::string quantity = table.required_text("map", "solid fraction");
  const MeasurementRun run = run_of_scene(table, context);
  std::vector<std::string> names = possible_maps();
  for (std::string& section : sections_of(run)) names.push_back(std::move(section));
  const bool known = std::any_of(names.begin(), names.end(),
                                 [&](const std::string& name) { return same_name(name, quantity); });
  return read_field(table, run, quantity, "map",
                    {names, known ? places_of_map(quantity) : std::vector<std::string>{},
                     possible_values(quantity).value_or(possible_in_sections())},
                    map_values);
}

}  // namespace diefill::process::calibration
