#include "process/results/studies/powder_spread.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/json_numbers.h"
#include "process/results/rounding.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value, int digits) {
  return std::isfinite(value) ? csv_number(value, digits) : "unknown";
}

Json entry(const SpreadFigure& figure) {
  return {{"key", figure.key},
          {"name", figure.name},
          {"unit", figure.unit},
          {"best_powder_mean", json_number(figure.best)},
          {"scatter_over_seeds", json_number(figure.scatter)},
          {"powders_mean", json_number(figure.mean)},
          {"spread_over_powders", json_number(figure.spread)},
          {"effect_of_the_powder", json_number(figure.powder)},
          {"significant", figure.significant},
          {"of_seeds", json_numbers(figure.of_seeds)},
          {"of_powders", json_numbers(figure.of_powders)}};
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

}  // namespace

std::string spread_text(const SpreadFigure& figure) {
  const std::string unit = unit_behind(figure.unit);
  const std::string seeds = "+-" + number(figure.scatter, 2) + unit + " over seeds",
                    start = figure.name + ' ' + number(figure.mean, 4) + unit + ": ";
  if (!std::isfinite(figure.powder) || figure.significant)
    return start + "+-" + number(figure.powder, 2) + unit + " by the powder, " + seeds;
  return start + seeds + "; the effect of the powder cannot be distinguished from the scatter over seeds";
}

void write_powder_spread(const std::filesystem::path& directory, const PowderSpread& spread) {
  write_text_atomically(directory / "powder_samples.json", json_of(spread));
  write_text_atomically(directory / "powder_samples.csv", csv_of(spread));
}

}  // namespace diefill::results
