#include "process/results/studies/calibration.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "process/results/csv_field.h"
#include "process/results/json_numbers.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

Json entry(const CalibratedParameter& parameter) {
  return {{"key", parameter.key},
          {"unit", parameter.unit},
          {"from", parameter.from},
          {"to", parameter.to},
          {"scale", parameter.logarithmic ? "logarithmic" : "linear"},
          {"best", json_number(parameter.best)},
          {"lower_90", json_number(parameter.lower)},
          {"upper_90", json_number(parameter.upper)},
          {"profile_at", json_numbers(parameter.profile_at)},
          {"profile_misfit", json_numbers(parameter.profile)}};
}

Json entry(const CalibrationDatum& datum, const CalibratedMeasurement& measurement) {
  Json json = Json::object();
  if (!measurement.x_name.empty()) json["x"] = json_number(datum.x);
  if (!measurement.second_name.empty()) json["second"] = json_number(datum.second);
  json["measured"] = json_number(datum.measured);
  json["deviation"] = json_number(datum.deviation);
  json["simulated"] = json_number(datum.simulated);
  json["uncertainty"] = json_number(datum.uncertainty);
  json["scatter_over_seeds"] = json_number(datum.scatter);
  json["lower_90"] = json_number(datum.lower);
  json["upper_90"] = json_number(datum.upper);
  if (std::isfinite(datum.finer)) json["simulated_with_finer_grains"] = datum.finer;
  return json;
}

Json entry(const CalibratedMeasurement& measurement) {
  Json json = {{"name", measurement.name},
               {"kind", measurement.kind},
               {"use", measurement.fitted ? "fit" : "check"},
               {"quantity", measurement.quantity},
               {"unit", measurement.unit}};
  if (!measurement.x_name.empty()) json["x"] = {{"name", measurement.x_name}, {"unit", measurement.x_unit}};
  if (!measurement.second_name.empty())
    json["second"] = {{"name", measurement.second_name}, {"unit", measurement.second_unit}};
  json["chi_square"] = json_number(measurement.chi_square);
  json["perpendicular_residual"] = json_number(measurement.residual);
  json["left_out_error"] = json_number(measurement.left_out_error);
  if (!measurement.remark.empty()) json["remark"] = measurement.remark;
  json["data"] = Json::array();
  for (const auto& datum : measurement.data) json["data"].push_back(entry(datum, measurement));
  return json;
}

Json entry(const CalibrationPoint& point) {
  Json json = {{"role", point.role}, {"values", json_numbers(point.values)}, {"state", point.state}};
  if (!point.reason.empty()) json["reason"] = point.reason;
  json["chi_square"] = json_number(point.chi_square);
  json["core_seconds"] = json_number(point.core_seconds);
  return json;
}

Json entry(const MeasurementWorth& worth) {
  return {{"name", worth.name},
          {"region_volume_ratio", json_number(worth.volume)},
          {"deviation_ratios", json_numbers(worth.deviations)}};
}

Json entry(const Screening& screening) {
  Json json = {{"runs", screening.runs},
               {"resolution", screening.resolution},
               {"letters", screening.letters},
               {"generators", screening.generators},
               {"defining_words", screening.words},
               {"standard_errors_from", screening.error_source}};
  json["quantities"] = Json::array();
  for (std::size_t q = 0; q < screening.quantities.size(); ++q) {
    const ScreenedQuantity& quantity = screening.quantities[q];
    Json one = {{"name", quantity.name},
                {"unit", quantity.unit},
                {"mean", json_number(quantity.mean)},
                {"standard_error", json_number(quantity.error)},
                {"margin_95", json_number(quantity.margin)},
                {"prediction_error_percent_main_effects", json_number(quantity.error_without)},
                {"prediction_error_percent_with_interactions", json_number(quantity.error_with)}};
    if (!quantity.error_source.empty()) one["standard_errors_from"] = quantity.error_source;
    one["effects"] = Json::object();
    for (const ScreenedEffect& effect : screening.effects)
      one["effects"][effect.string] = json_number(effect.values[q]);
    one["regression_coefficients"] = {{"mean", json_number(quantity.mean)}};
    for (const RegressionTerm& term : quantity.regression)
      one["regression_coefficients"][term.letters] = json_number(term.coefficient);
    json["quantities"].push_back(one);
  }
  return json;
}

template <class Item>
Json list(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const Item& item : items) json.push_back(entry(item));
  return json;
}

std::string json_of(const Calibration& calibration) {
  Json json = {{"title", calibration.title},
               {"command", calibration.command},
               {"program_version", calibration.program_version},
               {"powder", calibration.powder},
               {"fitted_with", calibration.grains},
               {"finer_grains", calibration.finer_grains},
               {"stopped", calibration.stopped},
               {"chi_square", json_number(calibration.chi_square)},
               {"fitted_values", calibration.data},
               {"agrees", calibration.agrees},
               {"insights", calibration.insights},
               {"remarks", calibration.remarks}};
  json["parameters"] = list(calibration.parameters);
  json["correlation"] = Json::array();
  for (const auto& row : calibration.correlation) json["correlation"].push_back(json_numbers(row));
  json["measurements"] = list(calibration.measurements);
  json["further_measurements"] = list(calibration.worth);
  json["points"] = list(calibration.points);
  json["samples"] = Json::array();
  for (const auto& sample : calibration.samples) json["samples"].push_back(json_numbers(sample));
  if (calibration.screening.runs > 0) json["screening"] = entry(calibration.screening);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string data_csv(const Calibration& calibration) {
  std::string text =
      "measurement,use,quantity,unit,x,x unit,second,second unit,measured,deviation,simulated,uncertainty,"
      "scatter over seeds,lower 90 %,upper 90 %\n";
  for (const auto& measurement : calibration.measurements)
    for (const auto& datum : measurement.data) {
      text += csv_text(measurement.name) + (measurement.fitted ? ",fit," : ",check,") +
              csv_text(measurement.quantity) + ',' + csv_text(measurement.unit);
      text += ',' + (measurement.x_name.empty() ? std::string() : csv_number(datum.x)) + ',' +
              csv_text(measurement.x_unit);
      text += ',' + (measurement.second_name.empty() ? std::string() : csv_number(datum.second)) + ',' +
              csv_text(measurement.second_unit);
      for (const double value : {datum.measured, datum.deviation, datum.simulated, datum.uncertainty,
                                 datum.scatter, datum.lower, datum.upper})
        text += ',' + csv_number(value, 6);
      text += '\n';
    }
  return text;
}

std::string points_csv(const Calibration& calibration) {
  std::string text = "role,state";
  for (const auto& parameter : calibration.parameters)
    text += ',' + csv_text(parameter.key + " [" + parameter.unit + "]");
  text += ",chi square,core seconds\n";
  for (const auto& point : calibration.points) {
    text += csv_text(point.role) + ',' + csv_text(point.state);
    for (const double value : point.values) text += ',' + csv_number(value, 8);
    text += ',' + csv_number(point.chi_square, 6) + ',' + csv_number(point.core_seconds, 6) + '\n';
  }
  return text;
}

std::string screening_csv(const Screening& screening) {
  std::string text = "effect,parameters";
  for (const auto& quantity : screening.quantities)
    text += ',' + csv_text(quantity.name + " [" + quantity.unit + "]");
  text += '\n';
  for (const auto& effect : screening.effects) {
    text += csv_text(effect.string) + ',' + csv_text(effect.words);
    for (const double value : effect.values) text += ',' + csv_number(value, 6);
    text += '\n';
  }
  text += "\"standard error\",";
  for (const auto& quantity : screening.quantities) text += ',' + csv_number(quantity.error, 6);
  text += "\n\"95 % margin\",";
  for (const auto& quantity : screening.quantities) text += ',' + csv_number(quantity.margin, 6);
  return text + '\n';
}

}  // namespace

const std::vector<std::string>& calibration_tables() {
  static const std::vector<std::string> names = {
      "calibration.json", "calibration.csv", "calibration_points.csv", "calibration.html",
      "calibration.pdf",  "screening.csv",   "screening.html",         "screening.pdf"};
  return names;
}

void write_calibration(const std::filesystem::path& directory, const Calibration& calibration) {
  write_text_atomically(directory / "calibration.json", json_of(calibration));
  write_text_atomically(directory / "calibration.csv", data_csv(calibration));
  write_text_atomically(directory / "calibration_points.csv", points_csv(calibration));
  if (calibration.screening.runs > 0)
    write_text_atomically(directory / "screening.csv", screening_csv(calibration.screening));
}

}  // namespace diefill::results
