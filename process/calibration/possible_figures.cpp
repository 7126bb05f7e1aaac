#include "process/calibration/possible_figures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "process/input/unit_conversion.h"
#include "process/results/figure_table.h"

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

/// Quantities of experiments; the first that is met counts. What is said of two runs, such as "D1 less D2",
/// may have either sign.
constexpr std::array<Rule, 9> kExperimentRules = {{{" less ", "", -kAny, kAny},
                                                   {"differ", "", -kAny, kAny},
                                                   {"drift", "", -kAny, kAny},
                                                   {"deviation", "", -kAny, kAny},
                                                   {"over apparent density", "1", 1, kAny},
                                                   {"solid fraction", "1", 0, 1},
                                                   {"share", "1", 0, 1},
                                                   {"angle", "deg", 0, 90},
                                                   {"theta", "deg", 0, 90}}};

/// Figures of the model's grains and walls, of what the scene prescribes, of the method's limits, and of the
/// computation.
constexpr std::array<std::string_view, 29> kOfComputation = {"grain_diameter_m",
                                                             "shoe_speed_m_s",
                                                             "smallest_grain_diameter_m",
                                                             "largest_grain_diameter_m",
                                                             "coarse_graining_factor",
                                                             "spheres",
                                                             "wall_spheres",
                                                             "grains_sheared",
                                                             "grain_diameter_over_cavity_width",
                                                             "critical_time_step_s",
                                                             "time_step_fraction",
                                                             "deepest_overlap_ratio",
                                                             "overlap_limit_ratio",
                                                             "deepest_wall_overlap_ratio",
                                                             "wall_overlap_limit_ratio",
                                                             "energy_balance_error",
                                                             "energy_error_limit",
                                                             "apparent_density_is_estimate",
                                                             "solid_fraction_grains",
                                                             "finished",
                                                             "steps",
                                                             "time_step_s",
                                                             "simulated_s",
                                                             "wall_seconds",
                                                             "threads",
                                                             "ranks",
                                                             "sphere_steps",
                                                             "sphere_steps_left_out",
                                                             "sphere_steps_per_second"};

/// Tables and keys of a scene that no experiment varies.
constexpr std::array<std::string_view, 6> kNotVaried = {"title",    "seed",    "setting",
                                                        "numerics", "economy", "variant"};

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

PossibleValues possible_values_of_experiment(const std::string& id, const std::string& called,
                                             const std::string& unit, double solid_density) {
  const std::string words = id + ", " + called;
  for (const Rule& rule : kExperimentRules)
    if (words.find(rule.part) != std::string::npos &&
        (*rule.unit == '\0' || has_same_dimension(unit, rule.unit)))
      return {*rule.unit == '\0' ? unit : rule.unit, rule.least, rule.most};
  if (has_same_dimension(unit, "kg/m^3")) return {"kg/m^3", 0, solid_density > 0 ? solid_density : kDensest};
  for (const char* positive : {"kg", "s", "1/s", "m^2", "m^3"})
    if (has_same_dimension(unit, positive)) return {unit, 0, kAny};
  return {unit, -kAny, kAny};
}

bool is_of_computation(const std::string& figure) {
  const results::Figure* known = results::find_figure(figure);
  return known != nullptr &&
         std::find(kOfComputation.begin(), kOfComputation.end(), known->name) != kOfComputation.end();
}

bool can_be_varied(const std::string& key) {
  const std::string first = key.substr(0, key.find_first_of(" \t."));
  return std::find(kNotVaried.begin(), kNotVaried.end(), first) == kNotVaried.end();
}

}  // namespace diefill::process::calibration
