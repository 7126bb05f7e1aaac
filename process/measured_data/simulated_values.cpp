#include "process/measured_data/simulated_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"

namespace diefill::process {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double factor_or_throw(const std::string& from, const std::string& to, const std::string& where) {
  try {
    return unit_factor(from, to);
  } catch (const UnitError& error) {
    throw SceneError(where + ": " + error.what());
  }
}

bool can_convert(const std::string& from, const std::string& to) {
  try {
    unit_factor(from, to);
    return true;
  } catch (const UnitError&) {
    return false;
  }
}

/// Place of `x` among rising nodes: index below and share towards the next; nothing outside.
struct Between {
  std::size_t below = 0;
  double share = 0;
};

std::optional<Between> between(const std::vector<double>& nodes, double x, bool round) {
  if (nodes.empty()) return std::nullopt;
  if (round && (x < nodes.front() || x > nodes.back())) {
    // Azimuths go on behind 360 degrees: between the last node and the first.
    const double gap = 360 - nodes.back() + nodes.front();
    const double past = std::fmod(x - nodes.back() + 720, 360);
    return gap > 0 ? std::optional<Between>({nodes.size() - 1, std::min(1.0, past / gap)}) : std::nullopt;
  }
  if (x < nodes.front() || x > nodes.back()) return std::nullopt;
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), x);
  if (next == nodes.end()) return Between{nodes.size() - 1, 0};
  const auto below = static_cast<std::size_t>(next - nodes.begin()) - 1;
  return Between{below, (x - nodes[below]) / (nodes[below + 1] - nodes[below])};
}

double mixed(double a, double b, double share) {
  return share == 0 ? a : (1 - share) * a + share * b;
}

double value_at(const results::Profile& profile, double x) {
  const auto at = between(profile.x, x, profile.x_name == "azimuth");
  if (!at) return kNone;
  return mixed(profile.y[at->below], profile.y[(at->below + 1) % profile.y.size()], at->share);
}

double value_at(const results::Field2D& field, double first, double second) {
  const auto i = between(field.first, first, field.first_name == "azimuth"),
             j = between(field.second, second, false);
  if (!i || !j) return kNone;
  const std::size_t width = field.first.size(), right = (i->below + 1) % width,
                    above = std::min(j->below + 1, field.second.size() - 1);
  const auto row = [&](std::size_t k) {
    return mixed(field.value[k * width + i->below], field.value[k * width + right], i->share);
  };
  return mixed(row(j->below), row(above), j->share);
}

/// The words there are, after the one that was probably meant.
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

}  // namespace

std::vector<double> profile_values(const results::FillResult& result, const std::string& quantity,
                                   const MeasuredTable& data, const std::string& where) {
  const MeasuredColumn& place = data.places[0];
  std::vector<std::string> known;
  const results::Profile* chosen = nullptr;  // of several, the one along the measured places
  for (const results::Profile& profile : result.profiles) {
    known.push_back(profile.quantity + " over " + profile.x_name);
    if (known.back() != quantity && profile.quantity != quantity) continue;
    if (chosen == nullptr || profile.x_name == place.name) chosen = &profile;
  }
  if (chosen == nullptr)
    throw SceneError(where + ": the result has no profile \"" + quantity + "\"; it has " +
                     listed(known, quantity));
  if (!can_convert(place.unit, chosen->x_unit))
    throw SceneError(where + ": found places as \"" + place.name + " [" + place.unit + "]\", but the " +
                     chosen->quantity + " of the result runs over \"" + chosen->x_name + " [" +
                     chosen->x_unit + "]\"");
  const double along = unit_factor(place.unit, chosen->x_unit),
               factor = factor_or_throw(chosen->unit, data.value.unit, where);
  std::vector<double> values;
  for (const double x : place.values) values.push_back(factor * value_at(*chosen, along * x));
  return values;
}

std::vector<double> map_values(const results::FillResult& result, const std::string& quantity,
                               const MeasuredTable& data, const std::string& where) {
  std::vector<std::string> known;
  for (const auto& [name, field] : fields_of(result)) {
    known.push_back(name);
    if (name != quantity) continue;
    const double first = factor_or_throw(data.places[0].unit, field->first_unit, where),
                 second = factor_or_throw(data.places[1].unit, field->second_unit, where);
    std::vector<double> values;
    for (std::size_t k = 0; k < data.size(); ++k)
      values.push_back(value_at(*field, first * data.places[0].values[k], second * data.places[1].values[k]));
    return values;
  }
  throw SceneError(where + ": the result has no map or section \"" + quantity + "\"; it has " +
                   listed(known, quantity));
}

}  // namespace diefill::process
