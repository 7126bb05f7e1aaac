#include "process/calibration/calibration_results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "process/calibration/methods/insight.h"
#include "process/calibration/methods/next_points.h"
#include "process/input/toml_string.h"
#include "process/input/units.h"
#include "process/results/formatted.h"
#include "process/results/none.h"
#include "process/scene/powder/grain_models.h"

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
  account.remarks.push_back("the simulations are too few: they add " + results::formatted("%.2g", share) +
                            " times the measurements' variance" +
                            (account.agrees ? ", so that the powder agrees says little" : ""));
}

/// A verdict on each measurement that was kept for checking, where the check was run.
void add_verdicts(results::Calibration& account, const SimulatedPoints& simulated) {
  if (std::none_of(simulated.points.begin(), simulated.points.end(),
                   [](const Point& point) { return point.checks; }))
    return;
  for (const auto& measurement : account.measurements)
    if (!measurement.fitted) account.insights.push_back(check_verdict(measurement));
}

void add_words(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
               const Fit& fit) {
  std::vector<std::string> keys, names;
  for (const ParameterRange& range : plan.parameters) keys.push_back(range.key);
  for (const std::size_t m : fit.measurement) names.push_back(plan.measurements[m].name);
  account.insights = insights(fit.region, keys, names);
  add_verdicts(account, simulated);
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

/// A number that TOML reads as one with a fraction.
std::string with_point(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  std::string number = text;
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

std::string grains_text(const Scene& scene) {
  const std::string grains =
      scene.powder.clump ? "clumps" : std::string("grain model ") + name_of(scene.powder.model);
  return grains + ", d = " + number_text(1e3 * scene.powder.grain_diameter) + " mm, " +
         (scene.walls.kind == WallKind::mesh
              ? "mesh walls"
              : "wall spheres of " + number_text(1e3 * scene.walls.sphere_radius) + " mm, spacing " +
                    number_text(scene.walls.spacing)) +
         (scene.contact ? ", [contact] of the powder file"
                        : ", reduced modulus " + number_text(1e-6 * scene.powder.reduced_modulus) + " MPa");
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
  const std::vector<double> best(fit->region.best.begin(), fit->region.best.end());
  account.grains =
      grains_text(scene_at(plan, plan.measurements[fit->measurement.front()].runs.front(), best));
  account.data = fit->likelihood->data();
  account.chi_square = fit->likelihood->chi_square(fit->region.best);
  account.agrees = explained_by_chance(account.chi_square, account.data, plan.parameters.size());
  add_emulator_share(account, *fit);
  add_worth(account, plan, simulated, *fit);
  add_words(account, plan, simulated, *fit);
  add_maps(account, plan, *fit);
  return account;
}

std::string powder_comment(const results::Calibration& account) {
  return "# Powder calibrated by diefill " + account.program_version + ": " + account.title +
         ".\n# A scene uses it with powder.file = \"powder.toml\". Uncertainties are listed at the end.\n";
}

std::string powder_calibration_table(const results::Calibration& account) {
  const auto number = [](double value) { return number_text(value); };
  std::string text = "[calibration]\nagrees = " + std::string(account.agrees ? "true" : "false") +
                     "\nchi_square = " + number(account.chi_square) +
                     "\nfitted_values = " + std::to_string(account.data) + "\n" + samples_text(account);
  for (const auto& parameter : account.parameters)
    text += "\n[[calibration.parameter]]\nkey = \"" + parameter.key + "\"\nunit = \"" + parameter.unit +
            "\"\nbest = " + number(parameter.best) + "\nlower_90 = " + number(parameter.lower) +
            "\nupper_90 = " + number(parameter.upper) + "\n";
  for (const auto& measurement : account.measurements)
    text += "\n[[calibration.measurement]]\nname = " + toml_string(measurement.name) + "\nuse = \"" +
            (measurement.fitted ? "fit" : "check") +
            "\"\nvalues = " + std::to_string(measurement.data.size()) + "\n";
  return text;
}

}  // namespace diefill::process::calibration
