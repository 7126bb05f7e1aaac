#include <algorithm>
#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/json_numbers.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"
#include "process/results/studies/experiment_result.h"

namespace diefill::results {

namespace {

using Json = nlohmann::ordered_json;

std::string role_of(const ExperimentSeries& series) {
  using Role = ExperimentSeries::Role;
  if (series.role == Role::published) return "published";
  return series.role == Role::predicted ? "predicted" : "measured";
}

Json json_of(const ExperimentLimit& limit) {
  return {{"limit", limit.name},
          {"measured", json_number(limit.measured)},
          {"predicted", json_number(limit.predicted)},
          {"unit", limit.unit},
          {"source", limit.source}};
}

Json json_of(const ExperimentChart& chart) {
  Json json = {{"name", chart.name}, {"title", chart.title}, {"x", chart.x.label}, {"y", chart.y.label}};
  json["series"] = Json::array();
  for (const auto& series : chart.series)
    json["series"].push_back({{"name", series.name},
                              {"role", role_of(series)},
                              {"x", json_numbers(series.x)},
                              {"y", json_numbers(series.y)}});
  return json;
}

Json json_of(const ExperimentResult& result) {
  Json json = {{"experiment", result.name},
               {"question", result.question},
               {"quick", result.quick},
               {"cpu_seconds", json_number(result.cpu_seconds)}};
  json["limits"] = Json::array();
  for (const auto& limit : result.limits) json["limits"].push_back(json_of(limit));
  json["charts"] = Json::array();
  for (const auto& chart : result.charts) json["charts"].push_back(json_of(chart));
  return json;
}

/// A field of a CSV file (RFC 4180), in quotation marks only where it needs them.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char letter : text) field += letter == '"' ? "\"\"" : std::string(1, letter);
  return field + "\"";
}

std::string csv_of(const ExperimentChart& chart) {
  const bool scatter = std::any_of(chart.series.begin(), chart.series.end(),
                                   [](const ExperimentSeries& series) { return !series.y_scatter.empty(); });
  std::string text = quoted(chart.x.label) + ",series,role," + quoted(chart.y.label) +
                     (scatter ? ",standard deviation over seeds\n" : "\n");
  for (const auto& series : chart.series)
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      text += csv_number(series.x[k]) + "," + quoted(series.name) + "," + role_of(series) + "," +
              csv_number(series.y[k]);
      if (scatter) text += "," + (series.y_scatter.empty() ? "" : csv_number(series.y_scatter[k]));
      text += "\n";
    }
  return text;
}

}  // namespace

void write_experiment(const std::filesystem::path& directory, const ExperimentResult& result) {
  write_text_atomically(directory / (result.name + ".json"),
                        json_of(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  for (const auto& chart : result.charts) write_chart(directory, chart);
}

void write_chart(const std::filesystem::path& directory, const ExperimentChart& chart) {
  write_text_atomically(directory / (chart.name + ".csv"), csv_of(chart));
}

void write_limits(const std::filesystem::path& directory, const std::string& name,
                  const std::vector<ExperimentResult>& results) {
  std::string csv = "experiment,limit,measured,predicted,unit,source\n";
  Json json = Json::array();
  for (const auto& result : results)
    for (const auto& limit : result.limits) {
      csv += quoted(result.name) + "," + quoted(limit.name) + "," + csv_number(limit.measured) + "," +
             csv_number(limit.predicted) + "," + quoted(limit.unit) + "," + quoted(limit.source) + "\n";
      Json row = json_of(limit);
      row["experiment"] = result.name;
      json.push_back(row);
    }
  write_text_atomically(directory / (name + ".csv"), csv);
  write_text_atomically(directory / (name + ".json"),
                        json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace diefill::results
