#include "process/calibration/parameter_range.h"

#include <algorithm>
#include <cmath>

#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"
#include "process/results/formatted.h"
#include "process/scene/key_path.h"
#include "process/scene/scene_text.h"

namespace diefill::process::calibration {
namespace {

constexpr NumberRule kPlain = {-1e12, 1e12, false, "0.25"};

/// A plain number, or a text with a unit.
NumberWithUnit end_of(TableReader& table, const std::string& key) {
  table.require(key, "0.2, or \"0.001 J/m^2\" for a key with a unit");
  std::optional<std::string> text;
  try {
    text = table.text(key);
  } catch (const SceneError&) {
    return {*table.number(key, kPlain), "1"};
  }
  try {
    return number_with_unit(*text);
  } catch (const UnitError& error) {
    table.reject(key, error.what());
  }
}

std::string written(double value) {
  return results::formatted("%.8g", value);
}

void check_key(const TableReader& table, const ParameterRange& range,
               const std::vector<ParameterRange>& earlier) {
  const auto begins = [&](const char* start) { return range.key.starts_with(start); };
  if (!begins("powder.") && !begins("contact.") && !begins("walls."))
    table.reject("key", "allowed: a key of [powder], [contact] or [walls], such as \"powder.friction\"");
  if (!is_key_path(range.key))
    table.reject("key",
                 "expected the path of a key alone, without \"=\", value or comment, such as "
                 "\"powder.friction\"");
  const auto same = [names = key_names(range.key)](const ParameterRange& other) {
    return key_names(other.key) == names;  // however they are quoted
  };
  if (std::any_of(earlier.begin(), earlier.end(), same))
    table.reject("key", "an earlier [[parameter]] has this key; give each key once");
}

}  // namespace

double ParameterRange::value_at(double place) const {
  if (logarithmic) return from * std::pow(to / from, place);
  return from + (to - from) * place;
}

double ParameterRange::place_of(double value) const {
  if (logarithmic) return std::log(value / from) / std::log(to / from);
  return (value - from) / (to - from);
}

std::string ParameterRange::assignment(double place) const {
  return assignment_line(key, written(value_at(place)), unit);
}

std::vector<ParameterRange> read_parameters(TableReader& document) {
  static const Choices<bool> scales = {{"linear", false}, {"logarithmic", true}};
  document.require("parameter", "a [[parameter]] with key, from and to");
  std::vector<ParameterRange> all;
  for (TableReader& table : document.tables("parameter")) {
    ParameterRange range;
    range.key = table.required_text("key", "powder.friction");
    check_key(table, range, all);
    const NumberWithUnit from = end_of(table, "from"), to = end_of(table, "to");
    range.logarithmic = table.choice("scale", scales).value_or(false);
    range.where_from = table.where("from");
    range.where_to = table.where("to");
    table.finish();
    range.unit = from.unit;
    range.from = from.number;
    try {
      range.to = to.number * unit_factor(to.unit, from.unit);
    } catch (const UnitError& error) {
      table.reject("to", error.what());
    }
    if (!(range.to > range.from)) table.reject("to", "allowed: more than \"from\"");
    if (range.logarithmic && !(range.from > 0))
      table.reject("from", "a logarithmic range begins above 0; raise it or use scale = \"linear\"");
    all.push_back(std::move(range));
  }
  if (all.empty()) document.reject("parameter", "expected at least one [[parameter]]");
  return all;
}

}  // namespace diefill::process::calibration
