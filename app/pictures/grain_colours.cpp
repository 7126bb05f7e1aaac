#include "app/pictures/grain_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/pictures/drawing.h"
#include "process/input/scene_error.h"
#include "process/measure/coordination.h"
#include "process/measure/earlier_instant.h"
#include "render/style/ticks.h"

namespace diefill::app {
namespace {

/// Height of every grain, mm, at the first instant kept, by its identity: the layer it comes from.
std::vector<double> origin_layers(const results::FillResult& result, const results::FillResult& whole) {
  if (whole.instants.empty()) process::result_at(whole, -1);  // says what is missing
  const auto first = process::powder_at(whole, whole.instants.front(), false).powder;
  std::vector<std::pair<std::uint64_t, double>> heights;
  for (std::size_t k = 0; k < first.id.size(); ++k)
    heights.emplace_back(first.id[k], 1e3 * first.position[k].z());
  std::sort(heights.begin(), heights.end());
  std::vector<double> values;
  for (const auto id : result.powder.id) {
    const auto found = std::lower_bound(heights.begin(), heights.end(),
                                        std::pair(id, -std::numeric_limits<double>::infinity()));
    values.push_back(found != heights.end() && found->first == id ? found->second : std::nan(""));
  }
  return values;
}

/// The powder of every grain as a number, and what the numbers mean.
void colour_by_powder(render::ViewOptions& options, const results::PowderState& powder) {
  const std::vector<std::string>& names = powder.kinds.material;
  const std::set<std::string> different(names.begin(), names.end());
  if (different.size() < 2)
    throw process::SceneError(
        "--colour-by powder: the result holds one powder only; choose another colour, such as diameter");
  const std::vector<std::string> sorted(different.begin(), different.end());
  std::vector<double> numbers;  // of kinds
  for (const auto& name : names) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), name);
    numbers.push_back(static_cast<double>(1 + (place - sorted.begin())));
  }
  options.kinds = sorted;
  for (const auto kind : powder.kind) options.values.push_back(numbers[kind]);
}

/// A third of the trace of the stress that contacts carry in the grain's cell, kPa; none without a closed
/// cell.
std::vector<double> pressures(const results::FillResult& result) {
  const auto& stress = result.contact_stress.normal;
  if (stress.size() != result.powder.position.size())
    throw process::SceneError(
        "--colour-by pressure: the results hold contact forces of the end of a run only; leave out --to, and "
        "run scenes of earlier versions again");
  constexpr double kPerKilopascal = 1e-3;
  std::vector<double> values;
  for (std::size_t k = 0; k < stress.size(); ++k)
    values.push_back(result.solid_fraction.open[k] != 0
                         ? std::nan("")
                         : -kPerKilopascal * stress[k].sum() / (3 * result.solid_fraction.cell_volume[k]));
  return values;
}

/// m/s, of all grains at all instants, or at the end where no instants are kept.
std::vector<double> speeds_over_time(const results::FillResult& result) {
  std::vector<double> speeds;
  for (const auto& instant : result.instants)
    for (const auto& velocity : instant.velocity) speeds.push_back(velocity.norm());
  if (result.instants.empty())
    for (const auto& velocity : result.powder.velocity) speeds.push_back(velocity.norm());
  return speeds;
}

std::vector<double> values_at_end(const results::FillResult& result, const std::string& by) {
  render::ViewOptions options;
  colour_grains(options, by, result, result);
  return options.values.empty() ? render::fractions_of_closed_cells(result) : options.values;
}

}  // namespace

const std::vector<std::string>& grain_colours() {
  static const std::vector<std::string> names = {"solid-fraction", "speed",  "layer",   "coordination",
                                                 "diameter",       "powder", "pressure"};
  return names;
}

void colour_grains(render::ViewOptions& options, const std::string& by, const results::FillResult& result,
                   const results::FillResult& whole) {
  options.values.clear();
  options.kinds.clear();
  if (by == "solid-fraction") return;
  options.grey_means = "no value";
  if (by == "speed") {
    options.quantity = "speed";
    options.unit = "m/s";
    for (const auto& velocity : result.powder.velocity) options.values.push_back(velocity.norm());
  } else if (by == "powder") {
    options.quantity = "powder";
    colour_by_powder(options, result.powder);
  } else if (by == "diameter") {
    options.quantity = "grain diameter";
    options.unit = "mm";
    for (std::size_t k = 0; k < result.powder.position.size(); ++k)
      options.values.push_back(1e3 * result.powder.diameter_of(k));
  } else if (by == "pressure") {
    options.quantity = "pressure by contact forces";
    options.unit = "kPa";
    options.values = pressures(result);
  } else if (by == "coordination") {
    options.quantity = "grains touched";
    for (const int number : process::coordination_numbers(result.powder)) options.values.push_back(number);
  } else {
    options.quantity = "height at the first stored instant";
    options.unit = "mm";
    options.values = origin_layers(result, whole);
  }
}

void fix_scale(render::ViewOptions& options, const std::string& by,
               const std::vector<const results::FillResult*>& results) {
  if (by == "powder" || (!std::isnan(options.lower) && !std::isnan(options.upper))) return;
  if (by == "solid-fraction") {
    const auto range = range_of_all_cavities(results);
    if (std::isnan(options.lower)) options.lower = range.lower;
    if (std::isnan(options.upper)) options.upper = range.upper;
    if (!std::isnan(options.lower) && !std::isnan(options.upper)) return;
  }
  std::vector<double> values;
  for (const auto* result : results) {
    const std::vector<double> own = by == "speed" ? speeds_over_time(*result) : values_at_end(*result, by);
    values.insert(values.end(), own.begin(), own.end());
  }
  if (std::ranges::none_of(values, [](double value) { return std::isfinite(value); })) return;
  const auto range = render::robust_range(values);
  if (std::isnan(options.lower)) options.lower = by == "speed" ? 0 : range.lower;
  if (std::isnan(options.upper)) options.upper = range.upper;
}

}  // namespace diefill::app
