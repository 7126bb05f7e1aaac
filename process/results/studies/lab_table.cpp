#include "process/results/studies/lab_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/formatted.h"
#include "process/results/json_numbers.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"
#include "process/results/studies/mean.h"

namespace diefill::results {

namespace {

using Json = nlohmann::ordered_json;

/// Four digits; from ten thousand to a million without a power of ten.
std::string short_number(double value) {
  const double size = std::abs(value);
  return results::formatted(size >= 1e4 && size < 1e6 ? "%.0f" : "%.4g", value);
}

Json json_of(const LabRow& row) {
  return {{"id", row.id},
          {"quantity", row.quantity},
          {"setting", row.setting},
          {"unit", row.unit},
          {"published", row.published},
          {"lower", json_number(row.lower)},
          {"upper", json_number(row.upper)},
          {"values", json_numbers(row.values)},
          {"mean", json_number(mean_of(row))},
          {"scatter", json_number(scatter_of(row))},
          {"verdict", row.verdict},
          {"reason", row.reason},
          {"grain_diameter_m", json_number(row.grain_diameter)},
          {"core_seconds", json_number(row.core_seconds)},
          {"seeds", seeds_of(row)}};
}

double number_in(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

LabRow row_of(const Json& json) {
  LabRow row;
  row.id = json.at("id").get<std::string>();
  row.quantity = json.at("quantity").get<std::string>();
  row.setting = json.at("setting").get<std::string>();
  row.unit = json.at("unit").get<std::string>();
  row.published = json.at("published").get<std::string>();
  row.lower = number_in(json, "lower");
  row.upper = number_in(json, "upper");
  row.values = json.at("values").get<std::vector<double>>();
  row.verdict = json.at("verdict").get<std::string>();
  row.reason = json.at("reason").get<std::string>();
  row.grain_diameter = number_in(json, "grain_diameter_m");
  row.core_seconds = number_in(json, "core_seconds");
  row.seeds = json.value("seeds", row.values.size());
  return row;
}

std::string csv_of(const LabTable& table) {
  std::string text =
      "id,quantity,setting,unit,published,lower,upper,mean,scatter,seeds,verdict,reason,grain diameter "
      "mm,core "
      "seconds\n";
  for (const LabRow& row : table.rows)
    text += csv_text(row.id) + ',' + csv_text(row.quantity) + ',' + csv_text(row.setting) + ',' +
            csv_text(row.unit) + ',' + csv_text(row.published) + ',' + csv_number(row.lower) + ',' +
            csv_number(row.upper) + ',' + csv_number(mean_of(row), 6) + ',' + csv_number(scatter_of(row), 3) +
            ',' + std::to_string(seeds_of(row)) + ',' + csv_text(row.verdict) + ',' + csv_text(row.reason) +
            ',' + csv_number(1e3 * row.grain_diameter, 6) + ',' + csv_number(row.core_seconds, 4) + '\n';
  return text;
}

}  // namespace

std::size_t seeds_of(const LabRow& row) {
  return std::max(row.seeds, row.values.size());
}

double mean_of(const LabRow& row) {
  return mean_of(row.values);
}

double scatter_of(const LabRow& row) {
  if (row.values.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const double mean = mean_of(row);
  double squares = 0;
  for (const double value : row.values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(row.values.size() - 1));
}

std::string published_text(const LabRow& row) {
  const bool least = std::isfinite(row.lower), most = std::isfinite(row.upper);
  std::string range;
  if (least && most) range = short_number(row.lower) + " to " + short_number(row.upper);
  if (least && !most) range = "at least " + short_number(row.lower);
  if (!least && most) range = "at most " + short_number(row.upper);
  if (row.published.empty()) return range.empty() ? "-" : range;
  return range.empty() ? row.published : row.published + " (" + range + ')';
}

std::string here_text(const LabRow& row) {
  if (row.values.empty()) return "-";
  const std::string mean = short_number(mean_of(row));
  if (row.values.size() < 2) return mean;
  char scatter[40];
  std::snprintf(scatter, sizeof scatter, "%.2g", scatter_of(row));
  return mean + " +- " + scatter;
}

void write_lab_table(const std::filesystem::path& directory, const LabTable& table) {
  Json json = {{"experiment", table.experiment},
               {"question", table.question},
               {"size", table.size},
               {"powder", table.powder},
               {"program_version", table.program_version},
               {"seeds", table.seeds},
               {"core_seconds", json_number(table.core_seconds)}};
  json["rows"] = Json::array();
  for (const LabRow& row : table.rows) json["rows"].push_back(json_of(row));
  write_text_atomically(directory / (table.experiment + ".json"),
                        json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  write_text_atomically(directory / (table.experiment + ".csv"), csv_of(table));
}

LabTable read_lab_table(const std::filesystem::path& directory, const std::string& experiment) {
  const auto file = directory / (experiment + ".json");
  std::ifstream stream(file);
  if (!stream) throw ResultError(file.string() + ": cannot be read");
  try {
    const Json json = Json::parse(stream);
    LabTable table;
    table.experiment = json.at("experiment").get<std::string>();
    table.question = json.at("question").get<std::string>();
    table.size = json.at("size").get<std::string>();
    table.powder = json.at("powder").get<std::string>();
    table.program_version = json.at("program_version").get<std::string>();
    table.seeds = json.at("seeds").get<int>();
    table.core_seconds = number_in(json, "core_seconds");
    for (const Json& row : json.at("rows")) table.rows.push_back(row_of(row));
    return table;
  } catch (const Json::exception&) {
    throw ResultError(file.string() + ": is not a laboratory table; run the experiment again");
  }
}

}  // namespace diefill::results
