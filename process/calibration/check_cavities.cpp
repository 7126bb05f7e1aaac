#include "process/calibration/check_cavities.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/known_fields.h"
#include "process/results/cavity_rows.h"
#include "process/results/word_list.h"
#include "process/setup/read_tooling.h"

namespace diefill::process::calibration {
namespace {

constexpr std::string_view kFurtherCavity = "cavity_";
constexpr std::size_t kMaxNames = 6;  // that a message lists

/// A figure's name in two: "cavity_3_fill_ratio" is "fill_ratio" of cavity 3.
struct CavityFigure {
  std::size_t cavity = 1;
  std::string name;
};

CavityFigure cavity_figure(const std::string& figure) {
  if (!figure.starts_with(kFurtherCavity)) return {1, figure};
  std::size_t number = 0;
  const char* const end = figure.data() + figure.size();
  const auto read = std::from_chars(figure.data() + kFurtherCavity.size(), end, number);
  if (read.ptr == end || *read.ptr != '_') return {1, figure};  // such as cavity_volume_m3
  if (read.ec == std::errc::result_out_of_range) number = std::numeric_limits<std::size_t>::max();
  return {number, std::string(read.ptr + 1, end)};
}

/// Whether each cavity of the die is a ring, the largest first; empty where they are not known before the
/// run.
using Rings = std::vector<bool>;

Rings rings_of(const Scene& scene, const ProgressCallback& on_progress) {
  const Tooling tooling = read_tooling(scene, on_progress);
  if (!tooling.cavity.found) return {};
  Rings rings = {tooling.cavity.is_ring};
  for (const auto& other : tooling.other_cavities) rings.push_back(other.is_ring);
  return rings;
}

std::string but_the_die_has(std::size_t cavities) {
  return "but the die has " + (cavities == 1 ? "one cavity" : std::to_string(cavities) + " cavities");
}

void refuse_other_cavities(const Measurement& measurement, const CavityFigure& figure, std::size_t cavities) {
  if (figure.cavity <= cavities) return;
  std::vector<std::string> allowed;
  for (std::size_t n = 1; n <= cavities; ++n)
    allowed.push_back('"' + results::figure_prefix(static_cast<int>(n)) + figure.name + '"');
  throw SceneError(measurement.figure_place + ": found \"" + measurement.figure + "\", " +
                   but_the_die_has(cavities) +
                   ", allowed: " + results::comma_list(allowed, kMaxNames, " or "));
}

/// A measured field that results of rings have, or those of all other cavities, over these places.
struct FieldOfShape {
  const char *kind, *quantity;
  bool ring;
  std::vector<std::string> places;
};

/// Those that process/measure makes of one shape alone.
const std::vector<FieldOfShape>& fields_of_one_shape() {
  static const std::vector<FieldOfShape> all = {
      {"profile", "fill level", true, {"azimuth"}},
      {"profile", "fill level", false, {"distance along the shoe's travel"}},
      {"profile", "filled fraction", true, {"azimuth"}},
      {"profile", "mean grain diameter", true, {"height", "azimuth", "travel"}},
      {"map", "solid fraction", true, {"azimuth", "height"}},
      {"map", "solid fraction", false, {"x", "y"}},
      {"map", "fill level", false, {"x", "y"}}};
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
void refuse_other_shape(const Measurement& measurement, const std::string& quantity, bool ring) {
  std::vector<std::string> there, of_other;
  for (const FieldOfShape& field : fields_of_one_shape()) {
    if (measurement.kind != field.kind || !same_name(field.quantity, quantity)) continue;
    const bool meant = std::all_of(measurement.data.places.begin(), measurement.data.places.end(),
                                   [&](const MeasuredColumn& place) { return runs_over(field, place); });
    if (meant && field.ring == ring) return;
    auto& places = field.ring == ring ? there : of_other;
    if (meant || field.ring == ring) places.insert(places.end(), field.places.begin(), field.places.end());
  }
  if (of_other.empty()) return;
  throw SceneError(
      measurement.data.places.front().where + ": only " + (ring ? "cavities that are no ring" : "rings") +
      " have a " + quantity + " over " + results::and_list(of_other) + ", and the cavity is " +
      (ring ? "a ring; " : "none; ") +
      (there.empty() ? "choose another quantity" : "allowed: places over " + results::and_list(there)));
}

void check_field(const Measurement& measurement, const Rings& rings) {
  const auto [named, cavity] = results::quantity_and_cavity(measurement.quantity);
  const auto number = static_cast<std::size_t>(cavity);
  if (number > rings.size())
    throw SceneError(measurement.data.where + ": found \"" + measurement.quantity + "\", " +
                     but_the_die_has(rings.size()));
  refuse_other_shape(measurement, named.substr(0, named.find(" over ")), rings[number - 1]);
}

}  // namespace

void check_cavities(const CalibrationPlan& plan, const ProgressCallback& on_progress) {
  std::map<std::string, Rings> known;  // by scene: several measurements may share one
  for (const Measurement& measurement : plan.measurements) {
    const bool field = measurement.kind == "profile" || measurement.kind == "map";
    const CavityFigure figure = cavity_figure(measurement.figure);
    if (!field && figure.cavity < 2) continue;
    const MeasurementRun& run = measurement.runs.front();
    const auto [rings, is_new] = known.emplace(run.file.string() + '\n' + run.set, Rings());
    if (is_new) rings->second = rings_of(scene_at(plan, run, {}), on_progress);
    if (rings->second.empty()) continue;
    if (field)
      check_field(measurement, rings->second);
    else
      refuse_other_cavities(measurement, figure, rings->second.size());
  }
}

}  // namespace diefill::process::calibration
