#include "process/calibration/possible_figures.h"

#include <array>
#include <limits>

#include "process/input/unit_conversion.h"

namespace diefill::process::calibration {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kDensest = 25000;  // kg/m^3, above all solids

/// Values of the figures whose names have `part`; the first that is met counts.
struct Rule {
  const char* part;
  const char* unit;  ///< of the limits; empty: the figure's own
  double least, most;
};

constexpr double kFullest = 2;  // a heap above the rim may hold more than the die

constexpr std::array<Rule, 12> kRules = {{{"_through_", "", -kAny, kAny},  // either way through a plane
                                          {"energy_", "", -kAny, kAny},
                                          {"azimuth_deg", "deg", -360, 720},
                                          {"slope_of_", "deg", -90, 90},
                                          {"diameter_top_minus_bottom", "", -kAny, kAny},
                                          {"top_minus_bottom", "1", -1, 1},
                                          {"along_travel", "1", -1, 1},
                                          {"mixing_index", "1", -1, 1},
                                          {"solid_fraction_grains", "1", 0, kAny},
                                          {"solid_fraction", "1", 0, 1},
                                          {"share", "1", 0, 1},
                                          {"fill_ratio", "1", 0, kFullest}}};

}  // namespace

PossibleValues possible_values_of_figure(const std::string& name, const std::string& unit) {
  // A zone or heap may be called as a part of another figure: the dimension tells.
  const auto meant = [&](const Rule& rule) {
    return name.find(rule.part) != std::string::npos &&
           (*rule.unit == '\0' || has_same_dimension(unit, rule.unit));
  };
  for (const Rule& rule : kRules)
    if (meant(rule)) return {*rule.unit == '\0' ? unit : rule.unit, rule.least, rule.most};
  if (has_same_dimension(unit, "kg/m^3")) return {"kg/m^3", 0, kDensest};
  return {unit, 0, kAny};
}

}  // namespace diefill::process::calibration
