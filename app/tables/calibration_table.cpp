#include "app/tables/calibration_table.h"

#include <cmath>

#include "app/tables/text_column.h"
#include "process/results/formatted.h"

namespace diefill::app {
namespace {

std::string number(double value, int digits = 3) {
  if (!std::isfinite(value)) return "-";
  return results::formatted("%.*g", digits, value);
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit == "1" || unit.empty() ? text : text + ' ' + unit;
}

/// A column of a table, with a blank before the next one.
std::string cell(const std::string& text, std::size_t width) {
  return padded(text, width) + ' ';
}

std::string parameters_of(const results::Calibration& calibration) {
  std::string lines = cell("parameter", 30) + cell("best", 16) + "90 % interval\n";
  for (const auto& parameter : calibration.parameters)
    lines += cell(parameter.key, 30) + cell(with_unit(number(parameter.best), parameter.unit), 16) +
             with_unit(number(parameter.lower) + " to " + number(parameter.upper), parameter.unit) + '\n';
  return lines;
}

std::string measurements_of(const results::Calibration& calibration) {
  constexpr std::size_t kMax = 12;  // values of a measurement that are listed one by one
  std::string lines = cell("measurement", 30) + cell("measured", 22) + cell("simulated", 12) +
                      "range over powders that agree\n";
  for (const auto& measurement : calibration.measurements) {
    const bool listed = measurement.data.size() <= kMax;
    if (!listed)
      lines += cell(measurement.name, 30) + std::to_string(measurement.data.size()) + " values, chi^2 " +
               number(measurement.chi_square) + (measurement.fitted ? "" : " (check)") + '\n';
    for (std::size_t k = 0; listed && k < measurement.data.size(); ++k) {
      const auto& datum = measurement.data[k];
      const std::string at =
          std::isfinite(datum.x) ? " at " + with_unit(number(datum.x), measurement.x_unit) : "";
      lines +=
          cell(measurement.name + at + (measurement.fitted ? "" : " (check)"), 30) +
          cell(with_unit(number(datum.measured, 4) + " +- " + number(datum.deviation, 2), measurement.unit),
               22) +
          cell(number(datum.simulated, 4), 12) + number(datum.lower, 4) + " to " + number(datum.upper, 4) +
          '\n';
    }
    if (!measurement.remark.empty()) lines += "  " + measurement.name + ": " + measurement.remark + '\n';
  }
  return lines;
}

/// What to do where no powder was found, or no effect.
std::string remedy_of(const results::Calibration& calibration) {
  const bool over_budget = calibration.stopped == "the budget is used";
  if (over_budget) return "the same command with --resume and a larger --budget goes on";
  if (calibration.open_runs > 0) return "finish the runs, then use --collect again";
  return "see calibration_points.csv for runs without a value and calibration.json for the reasons; change "
         "the "
         "ranges or the scenes";
}

std::string screening_of(const results::Screening& screening) {
  std::string lines =
      std::to_string(screening.runs) + " runs, " +
      (screening.resolution == 0 ? "full factorial" : "resolution " + std::to_string(screening.resolution)) +
      (screening.quantities.empty() ? "" : "; standard errors from " + screening.error_source) + '\n';
  for (const auto& generator : screening.generators) lines += "generator " + generator + '\n';
  for (std::size_t q = 0; q < screening.quantities.size(); ++q) {
    const auto& quantity = screening.quantities[q];
    lines += "effects on " + quantity.name + ", mean " + with_unit(number(quantity.mean, 4), quantity.unit) +
             ", 95 % margin " + number(quantity.margin) + '\n';
    for (const auto& effect : screening.effects)
      lines += "  " + cell(effect.string, 24) + cell(number(effect.values[q]), 12) +
               (std::abs(effect.values[q]) > quantity.margin ? "* " : "  ") + effect.words + '\n';
  }
  return lines;
}

}  // namespace

std::string calibration_table(const results::Calibration& calibration) {
  std::string lines;
  if (calibration.screening.runs > 0) {
    lines = screening_of(calibration.screening);
  } else if (calibration.fitted) {
    lines = parameters_of(calibration) + "chi^2 " + number(calibration.chi_square) + " of " +
            std::to_string(calibration.data) +
            " values: " + (calibration.agrees ? "agrees with the data" : "does not agree with the data") +
            '\n' + measurements_of(calibration);
  }
  for (const auto& sentence : calibration.insights) lines += "- " + sentence + '\n';
  for (const auto& remark : calibration.remarks) lines += "note: " + remark + '\n';
  const bool screened = calibration.screening.runs > 0;
  lines += "the search ended because " + calibration.stopped + '\n';
  if (screened ? calibration.screening.quantities.empty() : !calibration.fitted)
    lines += std::string(screened ? "no effects" : "no powder") + " found: " + remedy_of(calibration) + '\n';
  return lines;
}

}  // namespace diefill::app
