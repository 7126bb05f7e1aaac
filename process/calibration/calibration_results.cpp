#include "process/calibration/calibration_results.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "process/calibration/fitted_grains.h"
#include "process/calibration/methods/insight.h"
#include "process/calibration/methods/next_points.h"
#include "process/input/units.h"
#include "process/results/none.h"
#include "process/results/rounding.h"

namespace diefill::process::calibration {
namespace {

/// chi^2 of a point's own runs; NaN where a fitted value is missing. Without a fit, all values are to be
/// fitted.
double chi_square_of(const CalibrationPlan& plan, const PointOutcome& outcome,
                     const std::optional<Fit>& fit) {
  double sum = 0;
  std::size_t fitted = 0;  // among the measurements of the fit
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (!measurement.fitted) continue;
    std::vector<std::size_t> places(measurement.data.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    for (const std::size_t q : fit ? fit->places[fitted] : places)
      sum += std::pow((outcome.over_seeds(m, q).mean - measurement.data.value.values[q]) /
                          measurement.data.deviation.values[q],
                      2);
    ++fitted;
  }
  return sum;
}

void add_points(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
                const std::optional<Fit>& fit) {
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
    const Point& point = simulated.points[k];
    const PointOutcome& outcome = simulated.outcomes[k];
    results::CalibrationPoint row;
    row.role = point.role;
    for (std::size_t d = 0; d < point.place.size(); ++d)
      row.values.push_back(plan.parameters[d].value_at(point.place[d]));
    row.state = outcome.state;
    row.reason = outcome.reason;
    row.chi_square = chi_square_of(plan, outcome, fit);
    row.core_seconds = outcome.core_seconds;
    account.points.push_back(std::move(row));
  }
}

/// That the powder agrees says little where the emulators widen what would agree.
void add_emulator_share(results::Calibration& account, const Fit& fit) {
  const double share = mean_emulator_share(*fit.likelihood, fit.region);
  if (!(share > kShareThatMatters)) return;
  account.remarks.push_back("the simulations are too few: they add " +
                            results::in_significant_digits(share, 2) + " times the measurements' variance" +
                            (account.agrees ? ", so that the powder agrees says little" : ""));
}

/// Data that the parameters can always meet prove nothing.
void add_missing_freedom(results::Calibration& account) {
  const std::size_t values = account.data, parameters = account.parameters.size();
  if (!account.agrees || values > parameters) return;
  account.insights.push_back("that the powder agrees proves nothing: no degree of freedom is left (" +
                             std::to_string(values) + (values == 1 ? " value, " : " values, ") +
                             std::to_string(parameters) + (parameters == 1 ? " parameter" : " parameters") +
                             "); measure more to test the powder");
}

/// A verdict on each measurement that was kept for checking, where the check was run, and on each that was
/// run with finer grains.
void add_verdicts(results::Calibration& account, const CalibrationPlan& plan,
                  const SimulatedPoints& simulated) {
  const auto& points = simulated.points;
  if (std::any_of(points.begin(), points.end(), [](const Point& point) { return point.checks; }))
    for (const auto& measurement : account.measurements)
      if (!measurement.fitted) account.insights.push_back(check_verdict(measurement));
  if (std::any_of(points.begin(), points.end(), [](const Point& point) { return point.role == "finer"; }))
    for (const auto& measurement : account.measurements)
      account.insights.push_back(finer_verdict(measurement, plan.finer_grains, plan.seeds));
}

void add_words(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
               const Fit& fit) {
  std::vector<std::string> keys, names;
  for (const ParameterRange& range : plan.parameters) keys.push_back(range.key);
  for (const std::size_t m : fit.measurement) names.push_back(plan.measurements[m].name);
  add_missing_freedom(account);
  for (std::string& sentence : insights(fit.region, keys, names))
    account.insights.push_back(std::move(sentence));
  add_verdicts(account, plan, simulated);
  if (!account.worth.empty() && account.worth.front().volume < 0.95) {
    const auto& best = account.worth.front();
    account.insights.push_back("of the measurements known here, " + best.name +
                               " would help most: the region of parameters would shrink to " +
                               number_text(std::round(100 * best.volume)) + " % (linear estimate)");
  }
  if (!account.agrees)
    account.insights.push_back(
        "no parameters in these ranges agree with the data: chi^2 " +
        number_text(std::round(10 * account.chi_square) / 10) + " of " + std::to_string(account.data) +
        " values; the ranges are too narrow, the deviations too small, or the model cannot do this");
}

}  // namespace

results::Calibration calibration_results(const CalibrationPlan& plan, const SimulatedPoints& simulated,
                                         const std::optional<Fit>& fit) {
  results::Calibration account;
  account.title = plan.title;
  account.powder = plan.powder.filename().string();
  account.finer_grains = plan.finer_grains;
  account.fitted = fit.has_value();
  account.chi_square = kNone;
  add_points(account, plan, simulated, fit);
  add_parameters(account, plan, fit);
  add_measurements(account, plan, simulated, fit);
  std::size_t failed = 0;
  for (const auto& point : account.points) failed += point.state == "failed" ? 1 : 0;
  if (failed > 0)
    account.remarks.push_back(
        std::to_string(failed) + " of " + std::to_string(account.points.size()) +
        " sets of parameters have failed runs or runs without a value; their other runs are used; the table "
        "of points says why");
  if (!fit) return account;
  const auto grains = fitted_grains(plan, *fit);
  account.grains = text_of(grains);
  if (const std::string differing = differing_grains(grains); !differing.empty())
    account.remarks.push_back(differing);
  account.data = fit->likelihood->data();
  account.chi_square = fit->likelihood->chi_square(fit->region.best);
  account.agrees = explained_by_chance(account.chi_square, account.data, plan.parameters.size());
  add_emulator_share(account, *fit);
  add_worth(account, plan, simulated, *fit);
  add_words(account, plan, simulated, *fit);
  add_maps(account, plan, *fit);
  return account;
}

}  // namespace diefill::process::calibration
