// What the check of a calibration says: whether the powder predicts what was not fitted.
#include <cmath>
#include <limits>

#include "process/calibration/calibration_results.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process::calibration {
namespace {

constexpr double kByChance = 0.01;  // chi^2 that chance exceeds less often does not agree

/// Square of the difference over its variance. Half the region's range counts as one deviation more.
double squared_over_variance(const results::CalibrationDatum& datum, CheckedAgainst against) {
  const double own = std::isfinite(datum.uncertainty) ? datum.uncertainty : 0;
  double variance = datum.deviation * datum.deviation + own * own;
  if (against == CheckedAgainst::region && std::isfinite(datum.upper - datum.lower))
    variance += std::pow(0.5 * (datum.upper - datum.lower), 2);
  return std::pow(datum.simulated - datum.measured, 2) / variance;
}

std::size_t simulated_values(const results::CalibratedMeasurement& row) {
  std::size_t count = 0;
  for (const auto& datum : row.data) count += std::isfinite(datum.simulated) ? 1 : 0;
  return count;
}

/// The value that is furthest from the prediction.
std::string furthest(const results::CalibratedMeasurement& row) {
  const results::CalibrationDatum* worst = nullptr;
  for (const auto& datum : row.data)
    if (std::isfinite(datum.simulated) &&
        (worst == nullptr || squared_over_variance(datum, CheckedAgainst::region) >
                                 squared_over_variance(*worst, CheckedAgainst::region)))
      worst = &datum;
  const std::string unit = results::unit_behind(row.unit);
  const auto number = [](double value) { return results::formatted("%.4g", value); };
  return "measured " + number(worst->measured) + " +- " + number(worst->deviation) + unit + ", simulated " +
         number(worst->simulated) + unit + " (" + number(worst->lower) + " to " + number(worst->upper) +
         unit + " over the powders that agree)";
}

}  // namespace

bool explained_by_chance(double chi_square, std::size_t data, std::size_t parameters) {
  if (data <= parameters) return chi_square < 6.63;  // 1 % of one degree of freedom
  return chi_square < results::chi_squared_exceeded(static_cast<double>(data - parameters), kByChance);
}

double chi_square_of_check(const results::CalibratedMeasurement& row, CheckedAgainst against) {
  if (simulated_values(row) == 0) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const auto& datum : row.data)
    if (std::isfinite(datum.simulated)) sum += squared_over_variance(datum, against);
  return sum;
}

std::string check_verdict(const results::CalibratedMeasurement& row) {
  const std::string name = "the check \"" + row.name + "\" ";
  const std::size_t count = simulated_values(row);
  const auto met = [&](CheckedAgainst against) {
    return explained_by_chance(chi_square_of_check(row, against), count, 0);
  };
  if (count == 0) return name + "has no value at the best parameters: it says nothing";
  if (met(CheckedAgainst::deviation)) return name + "is predicted within its deviation";
  if (met(CheckedAgainst::region))
    return name + "is predicted within the region's range, but not by the best powder within its deviation";
  return name + "is missed: " + furthest(row);
}

}  // namespace diefill::process::calibration
