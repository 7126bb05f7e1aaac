#include "process/measured_data/compare_with_measured.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/known_fields.h"
#include "process/measured_data/profile_names.h"
#include "process/measured_data/simulated_values.h"
#include "process/results/none.h"
#include "process/results/studies/correlation.h"
#include "process/scene/zones.h"

namespace diefill::process {
namespace {

using Chosen = std::function<bool(std::size_t)>;

results::MeasuredZone zone_of(const std::string& name, const results::MeasuredComparison& comparison,
                              const Chosen& chosen) {
  std::vector<double> measured, simulated;
  for (std::size_t k = 0; k < comparison.measured.size(); ++k) {
    if (!chosen(k) || !std::isfinite(comparison.simulated[k])) continue;
    measured.push_back(comparison.measured[k]);
    simulated.push_back(comparison.simulated[k]);
  }
  results::MeasuredZone zone{name,  measured.size(), kNone,
                             kNone, kNone,           results::pearson_correlation(measured, simulated)};
  if (measured.empty()) return zone;
  const auto count = static_cast<double>(measured.size());
  zone.measured = zone.simulated = zone.rms = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    zone.measured += measured[k] / count;
    zone.simulated += simulated[k] / count;
    zone.rms += std::pow(simulated[k] - measured[k], 2) / count;
  }
  zone.rms = std::sqrt(zone.rms);
  return zone;
}

void add(results::MeasuredComparison& comparison, const std::string& name, const Chosen& chosen) {
  auto zone = zone_of(name, comparison, chosen);
  if (zone.points > 0) comparison.zones.push_back(std::move(zone));
}

/// Quarters of the circle in degrees, or thirds of the measured range in `unit`.
void add_parts(results::MeasuredComparison& comparison, const std::string& name, const std::string& unit,
               const std::vector<double>& at) {
  const bool round = name == "azimuth" && has_same_dimension(unit, "deg");
  const double degrees = round ? unit_factor(unit, "deg") : 0;
  const int parts = round ? 4 : 3;
  const auto [least, most] = std::minmax_element(at.begin(), at.end());
  const double start = round ? 0 : *least, width = (round ? 360 : *most - *least) / parts;
  if (!(width > 0)) return;
  for (int part = 0; part < parts; ++part) {
    char text[160];
    std::snprintf(text, sizeof text, "%s %.4g to %.4g %s", name.c_str(), start + part * width,
                  start + (part + 1) * width, round ? "deg" : unit.c_str());
    add(comparison, text, [&, part](std::size_t k) {
      const double place = round ? azimuth_in_circle(degrees * at[k]) : at[k];
      return std::clamp(static_cast<int>(std::floor((place - start) / width)), 0, parts - 1) == part;
    });
  }
}

/// Which laboratory coordinate a coordinate of a profile or map is; axis -1: none.
struct Along {
  int axis = -1;
  double offset = 0, scale = 0;  ///< m; m per unit
};

Along along(const std::string& name, const std::string& unit, const results::FillResult& result) {
  constexpr double kMillimetre = 1e-3;
  static const std::vector<std::string> names = {"x", "y", "z"};
  if (name == "azimuth") return {};
  const double scale = unit_factor(unit, "mm") * kMillimetre;
  // Heights of maps and profiles count from the cavity's floor.
  if (name == "height") return {2, result.cavity.lower_corner.z(), scale};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? Along{} : Along{static_cast<int>(found - names.begin()), 0, scale};
}

/// Zones of the scene whose limits concern only coordinates that the points have.
void add_zones(results::MeasuredComparison& comparison, const results::FillResult& result) {
  const Along first = along(comparison.first_name, comparison.first_unit, result),
              second = comparison.is_map() ? along(comparison.second_name, comparison.second_unit, result)
                                           : Along{};
  const auto known = [&](int axis) { return first.axis == axis || second.axis == axis; };
  const bool plan = known(0) && known(1);
  for (const Zone& zone : zones_in(result.scene_text)) {
    const bool round = zone.inner_radius > 0 || std::isfinite(zone.outer_radius);
    bool covers_cylinder = !round || plan;
    for (int axis = 0; axis < 3; ++axis)
      covers_cylinder =
          covers_cylinder && (known(axis) || (std::isinf(zone.lower[axis]) && std::isinf(zone.upper[axis])));
    if (!covers_cylinder) continue;
    add(comparison, zone.name, [&](std::size_t k) {
      const auto within = [&](const Along& one, double value) {
        if (one.axis < 0) return true;
        const double place = one.offset + one.scale * value;
        return place >= zone.lower[one.axis] && place <= zone.upper[one.axis];
      };
      if (!within(first, comparison.first[k])) return false;
      if (comparison.is_map() && !within(second, comparison.second[k])) return false;
      if (!round) return true;
      Eigen::Vector2d point;
      point[first.axis] = first.scale * comparison.first[k];
      point[second.axis] = second.scale * comparison.second[k];
      const double radius = (point - zone.axis).norm();
      return radius >= zone.inner_radius && radius <= zone.outer_radius;
    });
  }
}

/// Throws SceneError for a quantity of no profile of the result whose name is near that of one.
void refuse_misspelt_profile(const MeasuredTable& table, const results::FillResult& result) {
  std::vector<std::string> known;
  for (const results::Profile& profile : result.profiles)
    for (const std::string& name : names_of(profile)) {
      if (same_name(name, table.value.name)) return;
      known.push_back(name);
    }
  if (const auto meant = nearest_key(table.value.name, known))
    throw SceneError(table.value.where + ": found \"" + one_line(table.value.name) +
                     "\", of which the result has no profile; did you mean \"" + *meant + "\"?");
}

results::MeasuredComparison without_statistics(const MeasuredFile& measured,
                                               const results::FillResult& result) {
  const MeasuredTable& table = measured.table;
  const std::string where = measured.file.string();
  if (table.places.size() == 1) refuse_misspelt_profile(table, result);
  results::MeasuredComparison comparison;
  comparison.name = measured.file.stem().string();
  comparison.quantity = table.value.name;
  comparison.unit = table.value.unit;
  comparison.first_name = table.places[0].name;
  comparison.first_unit = table.places[0].unit;
  comparison.first = table.places[0].values;
  if (table.places.size() > 1) {
    comparison.second_name = table.places[1].name;
    comparison.second_unit = table.places[1].unit;
    comparison.second = table.places[1].values;
  }
  comparison.measured = table.value.values;
  comparison.deviation = table.deviation.values;
  comparison.simulated = table.places.size() > 1 ? map_values(result, comparison.quantity, table, where)
                                                 : profile_values(result, comparison.quantity, table, where);
  return comparison;
}

}  // namespace

std::vector<MeasuredFile> read_measured_files(const std::vector<std::string>& files) {
  std::vector<MeasuredFile> all;
  for (const std::string& file : files) {
    const std::filesystem::path path = file;
    for (const MeasuredFile& earlier : all)
      if (earlier.file.stem() == path.stem())
        throw SceneError("--measured: two files are called \"" + path.stem().string() +
                         "\"; give each file a unique name");
    all.push_back({path, read_measured_field(path)});
  }
  return all;
}

results::MeasuredComparison compare_with_measured(const MeasuredFile& measured,
                                                  const results::FillResult& result) {
  auto comparison = without_statistics(measured, result);
  add(comparison, "all", [](std::size_t) { return true; });
  if (comparison.zones.empty())
    throw SceneError(measured.file.string() + ": none of its " + std::to_string(comparison.measured.size()) +
                     " places lies where the result has a value of \"" + comparison.quantity +
                     "\"; check units and origin");
  add_zones(comparison, result);
  add_parts(comparison, comparison.first_name, comparison.first_unit, comparison.first);
  if (comparison.is_map())
    add_parts(comparison, comparison.second_name, comparison.second_unit, comparison.second);
  return comparison;
}

}  // namespace diefill::process
