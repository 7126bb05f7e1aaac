#include "process/calibration/calibration_results.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "process/calibration/methods/insight.h"
#include "process/input/units.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process::calibration {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kByChance = 0.01;  // chi^2 that chance exceeds less often does not agree

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::VectorXd mean_over(const std::vector<std::vector<double>>& rows) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.front().size()));
  for (const auto& row : rows) mean += vector_of(row) / static_cast<double>(rows.size());
  return mean;
}

/// chi^2 of a point's own runs; NaN where a fitted measurement has no values.
double chi_square_of(const CalibrationPlan& plan, const PointOutcome& outcome) {
  double sum = 0;
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (!measurement.fitted) continue;
    if (!outcome.has(m)) return kNone;
    sum += (mean_over(outcome.values[m]) - vector_of(measurement.data.value.values))
               .cwiseQuotient(vector_of(measurement.data.deviation.values))
               .squaredNorm();
  }
  return sum;
}

void add_points(results::Calibration& account, const CalibrationPlan& plan,
                const SimulatedPoints& simulated) {
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
    const Point& point = simulated.points[k];
    const PointOutcome& outcome = simulated.outcomes[k];
    results::CalibrationPoint row;
    row.role = point.role;
    for (std::size_t d = 0; d < point.place.size(); ++d)
      row.values.push_back(plan.parameters[d].value_at(point.place[d]));
    row.state = outcome.state;
    row.reason = outcome.reason;
    row.chi_square = chi_square_of(plan, outcome);
    row.core_seconds = outcome.core_seconds;
    account.points.push_back(std::move(row));
  }
}

/// Whether chance explains the chi^2; the parameters have used up as many of the data.
bool agrees(double chi_square, std::size_t data, std::size_t parameters) {
  if (data <= parameters) return chi_square < 6.63;  // 1 % of one degree of freedom
  return chi_square < results::chi_squared_exceeded(static_cast<double>(data - parameters), kByChance);
}

/// Predictions of a fitted measurement over samples of the region, one a row.
Eigen::MatrixXd predictions(const Emulator& emulator, const Eigen::MatrixXd& samples) {
  Eigen::MatrixXd values(samples.rows(), emulator.covariance().rows());
  for (Eigen::Index k = 0; k < samples.rows(); ++k)
    values.row(k) = emulator.at(samples.row(k).transpose()).mean.transpose();
  return values;
}

/// A measurement kept for checking as a linear function of the parameters, from the runs at the best and at
/// the edge; empty where too few have values.
Eigen::MatrixXd linear_predictions(std::size_t measurement, const SimulatedPoints& simulated,
                                   const Eigen::MatrixXd& samples) {
  std::vector<std::size_t> with;
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k)
    if (simulated.outcomes[k].has(measurement) && simulated.points[k].role != "finer") with.push_back(k);
  if (with.size() < 3) return {};
  const auto rows = static_cast<Eigen::Index>(with.size());
  Eigen::MatrixXd places(rows, samples.cols() + 1);
  Eigen::MatrixXd values;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const std::size_t k = with[static_cast<std::size_t>(r)];
    const Eigen::VectorXd mean = mean_over(simulated.outcomes[k].values[measurement]);
    if (r == 0) values.resize(rows, mean.size());
    values.row(r) = mean.transpose();
    places.row(r) << 1, vector_of(simulated.points[k].place).transpose();
  }
  const Eigen::MatrixXd coefficients = places.completeOrthogonalDecomposition().solve(values);
  Eigen::MatrixXd with_one(samples.rows(), samples.cols() + 1);
  with_one << Eigen::VectorXd::Ones(samples.rows()), samples;
  return with_one * coefficients;
}

void add_worth(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
               const Fit& fit) {
  constexpr Eigen::Index kSamples = 400;
  const Eigen::Index step = std::max<Eigen::Index>(1, fit.region.samples.rows() / kSamples);
  Eigen::MatrixXd samples(fit.region.samples.rows() / step, fit.region.samples.cols());
  for (Eigen::Index k = 0; k < samples.rows(); ++k) samples.row(k) = fit.region.samples.row(k * step);
  std::vector<PossibleMeasurement> possible;
  for (std::size_t k = 0; k < fit.measurement.size(); ++k) {
    const Measurement& measurement = plan.measurements[fit.measurement[k]];
    possible.push_back({measurement.name + ", once more",
                        predictions(*fit.likelihood->measurements()[k].emulator, samples),
                        vector_of(measurement.data.deviation.values)});
  }
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (measurement.fitted) continue;
    Eigen::MatrixXd values = linear_predictions(m, simulated, samples);
    if (values.size() > 0)
      possible.push_back({measurement.name + ", used to fit", std::move(values),
                          vector_of(measurement.data.deviation.values)});
  }
  for (const Informativeness& gain : informativeness_of(samples, possible))
    account.worth.push_back({gain.name, gain.volume, {gain.deviations.begin(), gain.deviations.end()}});
}

void add_words(results::Calibration& account, const CalibrationPlan& plan, const Fit& fit) {
  std::vector<std::string> keys, names;
  for (const ParameterRange& range : plan.parameters) keys.push_back(range.key);
  for (const std::size_t m : fit.measurement) names.push_back(plan.measurements[m].name);
  account.insights = insights(fit.region, keys, names);
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

/// As a text of TOML; names hold no control characters.
std::string in_quotes(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + '"';
}

std::string grains_text(const Scene& scene) {
  const bool is_clump = scene.powder.model == GrainModel::clump;
  const std::string grains =
      is_clump ? "clumps" : std::string("grain model ") + "ABCD"[static_cast<int>(scene.powder.model)];
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
  add_points(account, plan, simulated);
  add_parameters(account, plan, fit);
  add_measurements(account, plan, simulated, fit);
  std::size_t failed = 0;
  for (const auto& point : account.points) failed += point.state == "failed" ? 1 : 0;
  if (failed > 0)
    account.remarks.push_back(std::to_string(failed) + " of " + std::to_string(account.points.size()) +
                              " sets of parameters failed and were left out; the table of points says why");
  if (!fit) return account;
  const std::vector<double> best(fit->region.best.begin(), fit->region.best.end());
  account.grains =
      grains_text(scene_at(plan, plan.measurements[fit->measurement.front()].runs.front(), best));
  account.data = fit->likelihood->data();
  account.chi_square = fit->likelihood->chi_square(fit->region.best);
  account.agrees = agrees(account.chi_square, account.data, plan.parameters.size());
  add_worth(account, plan, simulated, *fit);
  add_words(account, plan, *fit);
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
    text += "\n[[calibration.measurement]]\nname = " + in_quotes(measurement.name) + "\nuse = \"" +
            (measurement.fitted ? "fit" : "check") +
            "\"\nvalues = " + std::to_string(measurement.data.size()) + "\n";
  return text;
}

}  // namespace diefill::process::calibration
