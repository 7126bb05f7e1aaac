#include "process/results/studies/powder_spread.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/figure_table.h"
#include "process/results/json_numbers.h"
#include "process/results/rounding.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

/// `values` divided by `divisor`.
Json numbers(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return json_numbers(values);
}

/// In the unit of report.json, since the key names it.
Json entry(const SpreadFigure& figure) {
  const auto [unit, divisor] = stored_as(figure.key, figure.unit);
  return {{"key", figure.key},
          {"name", figure.name},
          {"unit", unit},
          {"best_powder_mean", json_number(figure.best / divisor)},
          {"scatter_over_seeds", json_number(figure.scatter / divisor)},
          {"powders_mean", json_number(figure.mean / divisor)},
          {"spread_over_powders", json_number(figure.spread / divisor)},
          {"effect_of_the_powder", json_number(figure.powder / divisor)},
          {"significant", figure.significant},
          {"of_seeds", numbers(figure.of_seeds, divisor)},
          {"of_powders", numbers(figure.of_powders, divisor)}};
}

std::string json_of(const PowderSpread& spread) {
  Json json = {{"title", spread.title},
               {"command", spread.command},
               {"program_version", spread.program_version},
               {"powder_file", spread.powder_file},
               {"keys", spread.keys},
               {"units", spread.units},
               {"best_powder", json_numbers(spread.best)},
               {"failed", spread.failed}};
  json["powders"] = Json::array();
  for (const auto& powder : spread.powders) json["powders"].push_back(json_numbers(powder));
  json["figures"] = Json::array();
  for (const auto& figure : spread.figures) json["figures"].push_back(entry(figure));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string csv_of(const PowderSpread& spread) {
  std::string text =
      "figure,unit,best powder,scatter over seeds,mean over powders,spread over powders,effect of the "
      "powder,significant\n";
  for (const auto& figure : spread.figures) {
    text += csv_text(figure.name) + ',' + csv_text(figure.unit);
    for (const double value : {figure.best, figure.scatter, figure.mean, figure.spread, figure.powder})
      text += ',' + csv_number(value, 6);
    text += figure.significant ? ",yes\n" : ",no\n";
  }
  return text;
}

std::size_t known(const std::vector<double>& values) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); }));
}

/// How many runs have a value, where some have none.
std::string runs_with_values(const SpreadFigure& figure) {
  const std::size_t seeds = known(figure.of_seeds), powders = known(figure.of_powders);
  if (seeds == figure.of_seeds.size() && powders == figure.of_powders.size()) return {};
  return "; values of " + std::to_string(seeds) + " of " + std::to_string(figure.of_seeds.size()) +
         " runs of the best powder and of " + std::to_string(powders) + " of " +
         std::to_string(figure.of_powders.size()) + " powders";
}

}  // namespace

std::string spread_text(const SpreadFigure& figure) {
  const std::string unit = unit_behind(figure.unit), runs = runs_with_values(figure);
  const auto number = [&](double value, int digits) { return csv_number(value, digits) + unit; };
  if (!std::isfinite(figure.mean)) return figure.name + ": no value with the powders that were drawn" + runs;
  const std::string start = figure.name + ' ' + number(figure.mean, 4) + ": ";
  if (!std::isfinite(figure.scatter) || !std::isfinite(figure.powder))
    return start +
           (std::isfinite(figure.scatter) ? "+-" + number(figure.scatter, 2) + " over seeds; "
                                          : std::string()) +
           "too few values to tell the effect of the powder" + runs;
  if (figure.scatter == 0 && figure.spread == 0) return start + "the same in all runs" + runs;
  const std::string seeds =
      figure.scatter == 0 ? "no scatter over seeds" : "+-" + number(figure.scatter, 2) + " over seeds";
  if (figure.significant) return start + "+-" + number(figure.powder, 2) + " by the powder, " + seeds + runs;
  return start + seeds + "; the effect of the powder cannot be distinguished from the scatter over seeds" +
         runs;
}

void write_powder_spread(const std::filesystem::path& directory, const PowderSpread& spread) {
  write_text_atomically(directory / "powder_samples.json", json_of(spread));
  write_text_atomically(directory / "powder_samples.csv", csv_of(spread));
}

}  // namespace diefill::results
