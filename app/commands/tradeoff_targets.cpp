#include "app/commands/tradeoff_targets.h"

#include <algorithm>
#include <cmath>

#include "process/calibration/possible_figures.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"
#include "process/tradeoff/quantities.h"

namespace diefill::app {

namespace {

using results::TradeoffQuantity;

[[noreturn]] void refuse(const std::string& word, const std::string& why) {
  throw process::SceneError("--target: found \"" + process::one_line(word) + "\", " + why);
}

/// The number after the name, with the unit that it may have.
process::NumberWithUnit number_in(const std::string& word, std::size_t equals) {
  try {
    return process::number_with_unit(word.substr(equals + 1));
  } catch (const process::UnitError& error) {
    refuse(word, std::string("expected NAME=NUMBER in the unit of the CSV, or with its unit, such as "
                             "'filled_mass=12.5 g': ") +
                     error.what());
  }
}

double in_unit_of(const TradeoffQuantity& about, const process::NumberWithUnit& read,
                  const std::string& word) {
  if (read.unit == "1") return read.number;
  try {
    return read.number * process::unit_factor(read.unit, about.unit);
  } catch (const process::UnitError& error) {
    refuse(word, "but " + about.key + " has the unit \"" + about.unit + "\": " + error.what());
  }
}

void refuse_impossible(const TradeoffQuantity& about, double value, const std::string& word) {
  if (value == 0 && about.scale.empty()) refuse(word, "allowed: not 0, because errors are fractions of it");
  const auto possible = process::calibration::possible_values_of_figure(about.key, about.unit);
  const double there = value * process::unit_factor(about.unit, possible.unit);
  if (there >= possible.least && there <= possible.most) return;
  const std::string unit = possible.unit == "1" ? "" : ' ' + possible.unit;
  refuse(word, "allowed: " + process::number_text(possible.least) + unit +
                   (std::isfinite(possible.most) ? " to " + process::number_text(possible.most) + unit
                                                 : std::string(" or more")));
}

}  // namespace

std::map<std::string, double> read_targets(const std::vector<std::string>& words,
                                           const process::Scene& scene) {
  const auto quantities = process::measured_quantities(scene);
  std::map<std::string, double> targets;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) refuse(word, "expected NAME=NUMBER, such as 'filled_mass=12.5 g'");
    const std::string name = word.substr(0, equals);
    const auto read = number_in(word, equals);
    const auto quantity = std::find_if(quantities.begin(), quantities.end(),
                                       [&](const auto& one) { return one.about.key == name; });
    double value = read.number;
    if (quantity != quantities.end()) {
      value = in_unit_of(quantity->about, read, word);
      refuse_impossible(quantity->about, value, word);
    }
    if (!targets.emplace(name, value).second) refuse(word, "but " + name + " is given twice; keep one value");
  }
  return targets;
}

}  // namespace diefill::app
