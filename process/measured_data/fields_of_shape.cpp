#include "process/measured_data/fields_of_shape.h"

#include <algorithm>

#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/known_fields.h"
#include "process/results/cavity_rows.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

/// A measured field that results of rings have, or those of all other cavities, over these places.
struct FieldOfShape {
  bool profile;
  const char* quantity;
  bool ring;
  std::vector<std::string> places;
};

/// Those that process/measure makes of one shape alone.
const std::vector<FieldOfShape>& fields_of_one_shape() {
  static const std::vector<FieldOfShape> all = {
      {true, "fill level", true, {"azimuth"}},
      {true, "fill level", false, {"distance along the shoe's travel", "x", "y"}},
      {true, "filled fraction", true, {"azimuth"}},
      {true, "mean grain diameter", true, {"height", "azimuth", "travel"}},
      {false, "solid fraction", true, {"azimuth", "height"}},
      {false, "solid fraction", false, {"x", "y"}},
      {false, "fill level", false, {"x", "y"}}};
  return all;
}

/// Whether the field has places of this name; without a name, of its dimension.
bool runs_over(const FieldOfShape& field, const MeasuredColumn& place) {
  return std::any_of(field.places.begin(), field.places.end(), [&](const std::string& name) {
    return place.name == kUnnamedPlaces ? has_same_dimension(place.unit, name == "azimuth" ? "deg" : "mm")
                                        : same_name(name, place.name);
  });
}

/// Throws for a field that results of such a cavity never have, though they have it of others.
void refuse_other_shape(const MeasuredTable& table, const std::string& quantity, bool ring) {
  std::vector<std::string> there, of_other;
  for (const FieldOfShape& field : fields_of_one_shape()) {
    if (field.profile != (table.places.size() == 1) || !same_name(field.quantity, quantity)) continue;
    const bool meant = std::all_of(table.places.begin(), table.places.end(),
                                   [&](const MeasuredColumn& place) { return runs_over(field, place); });
    if (meant && field.ring == ring) return;
    auto& places = field.ring == ring ? there : of_other;
    if (meant || field.ring == ring) places.insert(places.end(), field.places.begin(), field.places.end());
  }
  if (of_other.empty()) return;
  throw SceneError(
      table.places.front().where + ": only " + (ring ? "cavities that are no ring" : "rings") + " have a " +
      quantity + " over " + results::and_list(of_other) + ", and the cavity is " +
      (ring ? "a ring; " : "none; ") +
      (there.empty() ? "choose another quantity" : "allowed: places over " + results::and_list(there)));
}

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& other) { return same_name(name, other); });
}

}  // namespace

void refuse_field_of_other_shape(const MeasuredTable& table, const std::string& quantity,
                                 const std::vector<bool>& rings) {
  const auto [named, cavity] = results::quantity_and_cavity(quantity);
  const auto number = static_cast<std::size_t>(cavity);
  if (number > rings.size())
    throw SceneError(table.where + ": found \"" + quantity + "\", " + but_the_die_has(rings.size()));
  refuse_other_shape(table, named.substr(0, named.find(" over ")), rings[number - 1]);
}

void refuse_unknown_field(const MeasuredTable& table, const std::vector<std::string>& sections) {
  std::vector<std::string> known = possible_profiles();
  if (table.places.size() > 1) {
    known = possible_maps();
    known.insert(known.end(), sections.begin(), sections.end());
  }
  const std::string quantity = results::quantity_and_cavity(table.value.name).first;
  if (!is_among(quantity, known) && !is_among(table.value.name, known))
    throw SceneError(table.value.where + ": " + not_among(table.value.name, known));
}

std::string but_the_die_has(std::size_t cavities) {
  return "but the die has " + (cavities == 1 ? "one cavity" : std::to_string(cavities) + " cavities");
}

}  // namespace diefill::process
