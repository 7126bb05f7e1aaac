#include "process/calibration/powder_origin.h"

#include <cmath>
#include <cstdio>

#include "process/calibration/calibration_results.h"
#include "process/calibration/fitted_grains.h"
#include "process/input/toml_string.h"
#include "process/input/units.h"
#include "process/results/rounding.h"

namespace diefill::process::calibration {
namespace {

/// A number that TOML reads as one with a fraction.
std::string with_point(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  std::string number = text;
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

std::string line(const std::string& key, const std::string& value) {
  return key + " = " + value + '\n';
}

/// Powders that agree, each with the values of the parameters below in their order.
std::string samples_text(const results::Calibration& account) {
  std::string text = "samples = [\n";
  for (const auto& sample : account.samples) {
    text += "  [";
    for (std::size_t k = 0; k < sample.size(); ++k) text += (k == 0 ? "" : ", ") + with_point(sample[k]);
    text += "],\n";
  }
  return text + "]\n";
}

std::string parameter_text(const results::CalibratedParameter& parameter) {
  return "\n[[calibration.parameter]]\n" + line("key", toml_string(parameter.key)) +
         line("unit", toml_string(parameter.unit)) + line("best", number_text(parameter.best)) +
         line("lower_90", number_text(parameter.lower)) + line("upper_90", number_text(parameter.upper));
}

/// A scene by its path from the calibration file, or an experiment by its name.
std::string source_of(const Measurement& measurement, const CalibrationPlan& plan) {
  if (!measurement.experiment.empty()) return line("experiment", toml_string(measurement.experiment));
  if (measurement.runs.empty()) return {};
  const std::filesystem::path scene = measurement.runs.front().file;
  const std::filesystem::path beside = scene.lexically_relative(plan.file.parent_path());
  return line("scene", toml_string((beside.empty() ? scene : beside).string()));
}

/// The value with its deviation; of several the first and the last.
std::string values_text(const results::CalibratedMeasurement& row) {
  const std::string unit = results::unit_behind(row.unit);
  const auto datum_text = [&](const std::string& start, const results::CalibrationDatum& datum) {
    return line(start + "value", toml_string(number_text(datum.measured) + unit)) +
           line(start + "deviation", toml_string(number_text(datum.deviation) + unit));
  };
  std::string text = line("values", std::to_string(row.data.size()));
  if (row.data.empty()) return text;
  if (row.data.size() == 1) return text + datum_text("", row.data.front());
  return text + datum_text("first_", row.data.front()) + datum_text("last_", row.data.back());
}

std::string verdict_of(const results::CalibratedMeasurement& row) {
  if (!row.fitted) return check_outcome(row);
  std::size_t compared = 0;
  for (const auto& datum : row.data) compared += std::isfinite(datum.simulated) ? 1 : 0;
  return explained_by_chance(row.chi_square, compared, 0) ? "agrees" : "does not agree";
}

std::string measurement_text(const results::CalibratedMeasurement& row, const Measurement& measurement,
                             const CalibrationPlan& plan) {
  std::string text = "\n[[calibration.measurement]]\n" + line("name", toml_string(row.name)) +
                     line("use", row.fitted ? "\"fit\"" : "\"check\"") +
                     line("quantity", toml_string(row.quantity)) + source_of(measurement, plan) +
                     values_text(row);
  if (std::isfinite(row.chi_square)) text += line("chi_square", number_text(row.chi_square));
  return text + line("verdict", toml_string(verdict_of(row)));
}

}  // namespace

std::string powder_comment(const results::Calibration& account, const CalibrationPlan& plan, const Fit& fit) {
  const std::string differing = differing_grains(fitted_grains(plan, fit));
  return "# Powder calibrated by diefill " + account.program_version + ": " + account.title +
         ".\n# A scene uses it with powder.file = \"powder.toml\". Uncertainties are listed at the end.\n" +
         (differing.empty() ? "" : "# Note: " + differing + ".\n");
}

std::string powder_calibration_table(const results::Calibration& account, const CalibrationPlan& plan) {
  std::string text = "[calibration]\n" + line("agrees", account.agrees ? "true" : "false") +
                     line("chi_square", number_text(account.chi_square)) +
                     line("fitted_values", std::to_string(account.data)) + samples_text(account);
  for (const auto& parameter : account.parameters) text += parameter_text(parameter);
  for (std::size_t m = 0; m < account.measurements.size(); ++m)
    text += measurement_text(account.measurements[m], plan.measurements[m], plan);
  return text;
}

}  // namespace diefill::process::calibration
