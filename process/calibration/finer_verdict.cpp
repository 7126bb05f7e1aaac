// What the check with finer grains says of a measurement.
#include <cmath>

#include "process/calibration/calibration_results.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process::calibration {
namespace {

constexpr double kByChance = 0.01;

double squared(double value) {
  return std::isfinite(value) ? value * value : 0;
}

/// Of the difference between both sizes over what the measurement leaves open and what seeds make.
double squared_over_variance(const results::CalibrationDatum& datum, int seeds) {
  return squared(datum.finer - datum.simulated) /
         (squared(datum.deviation) + squared(datum.uncertainty) + squared(datum.scatter) / seeds);
}

}  // namespace

std::string finer_verdict(const results::CalibratedMeasurement& row, const std::string& grains, int seeds) {
  const results::CalibrationDatum* furthest = nullptr;
  double chi_square = 0, count = 0;
  for (const auto& datum : row.data) {
    if (!std::isfinite(datum.finer) || !std::isfinite(datum.simulated)) continue;
    const double square = squared_over_variance(datum, seeds);
    if (furthest == nullptr || square > squared_over_variance(*furthest, seeds)) furthest = &datum;
    chi_square += square;
    count += 1;
  }
  const std::string start = "with finer grains (" + grains + ") \"" + row.name + "\" ";
  if (furthest == nullptr) return start + "has no value: this check says nothing of it";
  const std::string unit = results::unit_behind(row.unit);
  const auto number = [&](double value) { return results::formatted("%.4g", value) + unit; };
  const std::string values =
      start + "is " + number(furthest->finer) + " instead of " + number(furthest->simulated) +
      (count > 1 ? results::formatted(" where %.0f values differ most", count) : std::string()) +
      ", measured " + results::formatted("%.4g +- %.2g", furthest->measured, furthest->deviation) + unit;
  return values + (chi_square < results::chi_squared_exceeded(count, kByChance)
                       ? ": grain size makes no difference beyond deviation and scatter"
                       : ": grain size matters; use the powder with the grains that it was fitted with");
}

}  // namespace diefill::process::calibration
