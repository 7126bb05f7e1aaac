// Which further measurement would help most: what each would give over the powders that agree.
#include <algorithm>
#include <cmath>

#include "process/calibration/calibration_results.h"
#include "process/calibration/methods/insight.h"

namespace diefill::process::calibration {
namespace {

constexpr Eigen::Index kSamples = 400;

/// Rows of the region's samples that stand for all.
Eigen::MatrixXd some_samples(const Region& region) {
  const Eigen::Index step = std::max<Eigen::Index>(1, region.samples.rows() / kSamples);
  Eigen::MatrixXd samples(region.samples.rows() / step, region.samples.cols());
  for (Eigen::Index k = 0; k < samples.rows(); ++k) samples.row(k) = region.samples.row(k * step);
  return samples;
}

Eigen::VectorXd deviations_at(const Measurement& measurement, const std::vector<std::size_t>& places) {
  Eigen::VectorXd deviations(static_cast<Eigen::Index>(places.size()));
  for (std::size_t q = 0; q < places.size(); ++q)
    deviations[static_cast<Eigen::Index>(q)] = measurement.data.deviation.values[places[q]];
  return deviations;
}

/// Predictions of a fitted measurement, one sample a row.
Eigen::MatrixXd predictions(const Emulator& emulator, const Eigen::MatrixXd& samples) {
  Eigen::MatrixXd values(samples.rows(), emulator.covariance().rows());
  for (Eigen::Index k = 0; k < samples.rows(); ++k)
    values.row(k) = emulator.at(samples.row(k).transpose()).mean.transpose();
  return values;
}

/// A measurement kept for checking: the points that were run for it, and those of its values that all have.
struct CheckedRuns {
  std::vector<std::size_t> points, places;
};

CheckedRuns checked_runs(std::size_t measurement, std::size_t values, const SimulatedPoints& simulated) {
  CheckedRuns runs;
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k)
    if (simulated.outcomes[k].has(measurement) && simulated.points[k].role != "finer")
      runs.points.push_back(k);
  for (std::size_t q = 0; q < values; ++q)
    if (std::all_of(runs.points.begin(), runs.points.end(), [&](std::size_t k) {
          return simulated.outcomes[k].over_seeds(measurement, q).count > 0;
        }))
      runs.places.push_back(q);
  return runs;
}

/// As a linear function of the parameters, from the runs at the best and at the edge.
Eigen::MatrixXd linear_predictions(std::size_t measurement, const CheckedRuns& runs,
                                   const SimulatedPoints& simulated, const Eigen::MatrixXd& samples) {
  const auto rows = static_cast<Eigen::Index>(runs.points.size());
  Eigen::MatrixXd places(rows, samples.cols() + 1),
      values(rows, static_cast<Eigen::Index>(runs.places.size()));
  for (Eigen::Index r = 0; r < rows; ++r) {
    const std::size_t point = runs.points[static_cast<std::size_t>(r)];
    const auto& place = simulated.points[point].place;
    places.row(r) << 1, Eigen::Map<const Eigen::RowVectorXd>(place.data(), samples.cols());
    for (Eigen::Index q = 0; q < values.cols(); ++q)
      values(r, q) =
          simulated.outcomes[point].over_seeds(measurement, runs.places[static_cast<std::size_t>(q)]).mean;
  }
  const Eigen::MatrixXd coefficients = places.completeOrthogonalDecomposition().solve(values);
  Eigen::MatrixXd with_one(samples.rows(), samples.cols() + 1);
  with_one << Eigen::VectorXd::Ones(samples.rows()), samples;
  return with_one * coefficients;
}

/// Measurements kept for checking. A plane through as many points as it has coefficients would fit whatever
/// they scatter: it takes one more.
void add_checks(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
                const Eigen::MatrixXd& samples, std::vector<PossibleMeasurement>& possible) {
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (measurement.fitted) continue;
    const CheckedRuns runs = checked_runs(m, measurement.data.size(), simulated);
    if (runs.points.empty() || runs.places.empty()) continue;
    if (runs.points.size() <= plan.parameters.size() + 1)
      account.remarks.push_back("what \"" + measurement.name +
                                "\" would add to the fit is not estimated: it was run for " +
                                std::to_string(runs.points.size()) + " sets of parameters, at least " +
                                std::to_string(plan.parameters.size() + 2) + " are needed");
    else
      possible.push_back({measurement.name + ", used to fit", linear_predictions(m, runs, simulated, samples),
                          deviations_at(measurement, runs.places)});
  }
}

}  // namespace

void add_worth(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
               const Fit& fit) {
  const Eigen::MatrixXd samples = some_samples(fit.region);
  std::vector<PossibleMeasurement> possible;
  for (std::size_t k = 0; k < fit.measurement.size(); ++k) {
    const Measurement& measurement = plan.measurements[fit.measurement[k]];
    possible.push_back({measurement.name + ", once more",
                        predictions(*fit.likelihood->measurements()[k].emulator, samples),
                        deviations_at(measurement, fit.places[k])});
  }
  add_checks(account, plan, simulated, samples, possible);
  for (const Informativeness& gain : informativeness_of(samples, possible))
    account.worth.push_back({gain.name, gain.volume, {gain.deviations.begin(), gain.deviations.end()}});
}

}  // namespace diefill::process::calibration
