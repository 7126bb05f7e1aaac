#include "process/results/studies/tradeoff.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/json_numbers.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

Json quantity_entry(const TradeoffQuantity& quantity) {
  return {{"key", quantity.key},
          {"name", quantity.name_in_files()},
          {"unit", quantity.unit},
          {"decides", quantity.decides},
          {"errors_relative_to", quantity.scale.empty() ? quantity.key : quantity.scale},
          {"reference", json_number(quantity.reference)},
          {"reference_is_target", quantity.is_target},
          {"scatter", json_number(quantity.scatter)},
          {"floor", json_number(quantity.floor)}};
}

Json point_entry(const TradeoffPoint& point, const std::vector<TradeoffQuantity>& quantities) {
  Json json = {{"setting", point.name}, {"changes", Json::object()}, {"state", point.state}};
  for (const auto& change : point.changes) json["changes"][change.parameter] = change.value;
  if (!point.reason.empty()) json["reason"] = point.reason;
  json["seeds"] = point.seeds;
  json["core_seconds"] = json_number(point.core_seconds);
  json["core_seconds_per_simulated_second"] = json_number(point.core_seconds_per_second);
  json["wall_seconds"] = json_number(point.wall_seconds);
  json["peak_memory_bytes"] = json_number(point.peak_memory_bytes);
  json["error"] = json_number(point.error);
  json["worst_quantity"] = point.worst;
  json["beyond_scatter_and_tolerance"] = point.beyond;
  json["reference"] = point.reference;
  json["pareto"] = point.pareto;
  json["recommended"] = point.recommended;
  for (std::size_t q = 0; q < point.values.size(); ++q) {
    const TradeoffValue& value = point.values[q];
    json["values"][quantities[q].key] = {{"mean", json_number(value.mean)},
                                         {"scatter", json_number(value.scatter)},
                                         {"seeds", value.seeds},
                                         {"error", json_number(value.error)}};
  }
  return json;
}

std::string csv_head(const std::vector<TradeoffQuantity>& quantities) {
  std::string text =
      "setting,state,seeds,core_seconds,core_seconds_per_simulated_second,wall_seconds,peak_memory_MiB,error,"
      "floor,worst_quantity,beyond,reference,pareto,recommended";
  for (const auto& quantity : quantities)
    text += ',' + csv_text(quantity.name_in_files() + " [" + quantity.unit + "]") + ',' +
            csv_text(quantity.name_in_files() + ", scatter") + ',' +
            csv_text(quantity.name_in_files() + ", error");
  return text + '\n';
}

/// Words with blanks between them.
std::string in_one(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string csv_line(const TradeoffPoint& point, double floor) {
  const auto flag = [](bool value) { return std::string(value ? ",1" : ",0"); };
  constexpr double kMebibyte = 1024.0 * 1024.0;
  std::string text =
      csv_text(point.name) + ',' + csv_text(point.state) + ',' + std::to_string(point.seeds) + ',' +
      csv_number(point.core_seconds, 6) + ',' + csv_number(point.core_seconds_per_second, 6) + ',' +
      csv_number(point.wall_seconds, 6) + ',' + csv_number(point.peak_memory_bytes / kMebibyte, 6) + ',' +
      csv_number(point.error, 6) + ',' + csv_number(floor, 6) + ',' + csv_text(point.worst) + ',' +
      csv_text(in_one(point.beyond)) + flag(point.reference) + flag(point.pareto) + flag(point.recommended);
  for (const TradeoffValue& value : point.values)
    text += ',' + csv_number(value.mean, 6) + ',' + csv_number(value.scatter, 6) + ',' +
            csv_number(value.error, 6);
  return text + '\n';
}

}  // namespace

void write_tradeoff(const std::filesystem::path& directory, const Tradeoff& tradeoff) {
  Json json = {{"title", tradeoff.title},         {"command", tradeoff.command},
               {"advice", tradeoff.advice},       {"floor", json_number(tradeoff.floor)},
               {"tolerance", tradeoff.tolerance}, {"remarks", tradeoff.remarks}};
  json["quantities"] = Json::array();
  for (const auto& quantity : tradeoff.quantities) json["quantities"].push_back(quantity_entry(quantity));
  json["settings"] = Json::array();
  std::string csv = csv_head(tradeoff.quantities);
  for (const auto& point : tradeoff.points) {
    json["settings"].push_back(point_entry(point, tradeoff.quantities));
    csv += csv_line(point, tradeoff.floor);
  }
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  write_text_atomically(directory / "tradeoff.json", text);
  write_text_atomically(directory / "tradeoff.csv", csv);
}

}  // namespace diefill::results
