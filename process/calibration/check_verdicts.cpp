// What the check of a calibration says: whether the powder predicts what was not fitted.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/calibration/calibration_results.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process::calibration {
namespace {

constexpr double kByChance = 0.01;  // chi^2 that chance exceeds less often does not agree

/// Variance of the mean of the runs at the best parameters over seeds; 0 where it is not known.
double variance_over_seeds(const results::CalibrationDatum& datum) {
  return std::isfinite(datum.uncertainty) ? datum.uncertainty * datum.uncertainty : 0;
}

/// Variance of the difference. Half the region's range counts as one deviation more.
double variance_of(const results::CalibrationDatum& datum, CheckedAgainst against) {
  double variance = datum.deviation * datum.deviation + variance_over_seeds(datum);
  if (against == CheckedAgainst::region && std::isfinite(datum.upper - datum.lower))
    variance += std::pow(0.5 * (datum.upper - datum.lower), 2);
  return variance;
}

double squared_over_variance(const results::CalibrationDatum& datum, CheckedAgainst against) {
  return std::pow(datum.simulated - datum.measured, 2) / variance_of(datum, against);
}

/// Degrees of freedom of the variances, of which the part over seeds alone is estimated (F. E. Satterthwaite,
/// Biometrics Bulletin 2, 1946): that of one value is freedom / share^2, with the share of that part.
double freedom_of(const results::CalibratedMeasurement& row, CheckedAgainst against) {
  double inverse = 0, count = 0;
  for (const auto& datum : row.data) {
    if (!std::isfinite(datum.simulated)) continue;
    count += 1;
    if (datum.freedom > 0)
      inverse += std::pow(variance_over_seeds(datum) / variance_of(datum, against), 2) / datum.freedom;
  }
  return count / inverse;
}

/// The chi^2 that chance exceeds in 1 % of cases: of one value the square of Student's t, of several their
/// number times Fisher's F.
double limit_of(std::size_t values, double freedom) {
  constexpr double kAsGoodAsKnown = 1e6;
  const double count = static_cast<double>(values);
  return freedom > kAsGoodAsKnown ? results::chi_squared_exceeded(count, kByChance)
                                  : count * results::variance_ratio_exceeded(count, freedom, kByChance);
}

std::size_t simulated_values(const results::CalibratedMeasurement& row) {
  std::size_t count = 0;
  for (const auto& datum : row.data) count += std::isfinite(datum.simulated) ? 1 : 0;
  return count;
}

bool has_unknown_scatter(const results::CalibratedMeasurement& row) {
  return std::any_of(row.data.begin(), row.data.end(), [](const auto& datum) {
    return std::isfinite(datum.simulated) && !(datum.freedom > 0);
  });
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
  const std::size_t freedom = data > parameters ? data - parameters : 1;
  return chi_square < results::chi_squared_exceeded(static_cast<double>(freedom), kByChance);
}

double chi_square_of_check(const results::CalibratedMeasurement& row, CheckedAgainst against) {
  if (simulated_values(row) == 0) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const auto& datum : row.data)
    if (std::isfinite(datum.simulated)) sum += squared_over_variance(datum, against);
  return sum;
}

std::string check_outcome(const results::CalibratedMeasurement& row) {
  const std::size_t count = simulated_values(row);
  const auto met = [&](CheckedAgainst against) {
    return chi_square_of_check(row, against) < limit_of(count, freedom_of(row, against));
  };
  if (count == 0) return "has no value at the best parameters: it says nothing";
  const std::string unknown =
      has_unknown_scatter(row)
          ? "; its scatter over seeds is not known and counts as 0: no set of parameters has two runs of it"
          : "";
  if (met(CheckedAgainst::deviation)) return "is predicted within its deviation" + unknown;
  if (met(CheckedAgainst::region))
    return "is predicted within the region's range, but not by the best powder within its deviation" +
           unknown;
  return "is missed: " + furthest(row) + unknown;
}

std::string check_verdict(const results::CalibratedMeasurement& row) {
  return "the check \"" + row.name + "\" " + check_outcome(row);
}

}  // namespace diefill::process::calibration
