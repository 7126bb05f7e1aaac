#include "process/results/studies/comparison.h"

#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/figure_table.h"
#include "process/results/json_numbers.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

/// Divisors of numbers under these keys, whose names state the unit of report.json.
std::map<std::string, double> divisors_of(const std::vector<ComparedMeasure>& measures) {
  std::map<std::string, double> divisors;
  for (const ComparedMeasure& measure : measures)
    divisors[measure.key] = stored_as(measure.key, measure.unit).divisor;
  return divisors;
}

Json run_entry(const ComparedRun& run, const std::map<std::string, double>& divisors) {
  Json json = {{"variant", run.variant}, {"seed", run.seed}, {"folder", run.folder}, {"state", run.state}};
  if (!run.reason.empty()) {
    if (run.state != "finished") json["exit_code"] = run.exit_code;
    json["reason"] = run.reason;
  }
  if (!run.state_hash.empty()) json["state_hash"] = run.state_hash;
  for (const auto& [key, value] : run.values) json["values"][key] = json_number(value / divisors.at(key));
  return json;
}

Json measure_entry(const ComparedMeasure& measure, const std::vector<std::string>& variants) {
  const auto [unit, divisor] = stored_as(measure.key, measure.unit);
  Json json = {{"key", measure.key}, {"name", measure.name}, {"unit", unit}};
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const ComparedValue& value = measure.values[k];
    json["variants"].push_back({{"variant", variants[k]},
                                {"mean", json_number(value.mean / divisor)},
                                {"scatter", json_number(value.scatter / divisor)},
                                {"seeds", value.seeds},
                                {"difference", json_number(value.difference / divisor)},
                                {"interval_95", json_number(value.interval / divisor)},
                                {"verdict", description(value.verdict)}});
  }
  return json;
}

std::string csv(const Comparison& comparison) {
  std::string text = "variant,measure,unit,mean,scatter,seeds,difference,interval_95,verdict\n";
  for (std::size_t k = 0; k < comparison.variants.size(); ++k)
    for (const ComparedMeasure& measure : comparison.measures) {
      const ComparedValue& value = measure.values[k];
      text += csv_text(comparison.variants[k]) + ',' + csv_text(measure.name) + ',' + csv_text(measure.unit) +
              ',' + csv_number(value.mean) + ',' + csv_number(value.scatter) + ',' +
              std::to_string(value.seeds) + ',' + csv_number(value.difference) + ',' +
              csv_number(value.interval) + ',' + csv_text(description(value.verdict)) + '\n';
    }
  return text;
}

}  // namespace

std::string description(Verdict verdict) {
  switch (verdict) {
    case Verdict::reference:
      return "reference";
    case Verdict::none:
      return "none";
    case Verdict::different:
      return "different";
    case Verdict::scatter_unknown:
      return "scatter unknown";
    case Verdict::missing:
      break;
  }
  return "no value";
}

std::string statistics_text() {
  return "scatter: standard deviation over seeds; difference: from the first variant, 'none' where it is "
         "within "
         "the 95 % interval of Welch's t for two means, 'scatter unknown' where one of the two has one seed";
}

void write_comparison(const std::filesystem::path& directory, const Comparison& comparison) {
  Json json;
  json["title"] = comparison.title;
  json["reference"] = comparison.variants.front();
  json["variants"] = comparison.variants;
  json["statistics"] = statistics_text();
  json["measures"] = Json::array();
  for (const auto& measure : comparison.measures)
    json["measures"].push_back(measure_entry(measure, comparison.variants));
  json["runs"] = Json::array();
  const auto divisors = divisors_of(comparison.measures);
  for (const auto& run : comparison.runs) json["runs"].push_back(run_entry(run, divisors));
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  write_text_atomically(directory / "comparison.json", text);
  write_text_atomically(directory / "comparison.csv", csv(comparison));
}

}  // namespace diefill::results
