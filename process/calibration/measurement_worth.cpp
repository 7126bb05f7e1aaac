// Which further measurement would help most: what each would give over the powders that agree.
#include <algorithm>
#include <cmath>

#include "process/calibration/calibration_results.h"
#include "process/calibration/methods/insight.h"
#include "process/results/studies/quantiles.h"
#include "process/tradeoff/evaluate.h"

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

/// Values at these points, a row each, and the plane through them.
struct Plane {
  Eigen::MatrixXd places, values, coefficients;  ///< places: 1, then the parameters

  Eigen::MatrixXd at(const Eigen::MatrixXd& samples) const {
    Eigen::MatrixXd with_one(samples.rows(), samples.cols() + 1);
    with_one << Eigen::VectorXd::Ones(samples.rows()), samples;
    return with_one * coefficients;
  }
};

/// A measurement as a linear function of the parameters, from the runs at the best and at the edge.
Plane plane_through(std::size_t measurement, const CheckedRuns& runs, const SimulatedPoints& simulated,
                    Eigen::Index parameters) {
  const auto rows = static_cast<Eigen::Index>(runs.points.size());
  Plane plane{Eigen::MatrixXd(rows, parameters + 1),
              Eigen::MatrixXd(rows, static_cast<Eigen::Index>(runs.places.size())),
              {}};
  for (Eigen::Index r = 0; r < rows; ++r) {
    const std::size_t point = runs.points[static_cast<std::size_t>(r)];
    const auto& place = simulated.points[point].place;
    plane.places.row(r) << 1, Eigen::Map<const Eigen::RowVectorXd>(place.data(), parameters);
    for (Eigen::Index q = 0; q < plane.values.cols(); ++q)
      plane.values(r, q) =
          simulated.outcomes[point].over_seeds(measurement, runs.places[static_cast<std::size_t>(q)]).mean;
  }
  plane.coefficients = plane.places.completeOrthogonalDecomposition().solve(plane.values);
  return plane;
}

/// Variance of one value of the runs at a point, with its degrees of freedom: over seeds, or without repeats
/// about the plane.
struct PointScatter {
  double variance = 0, freedom = 0;
};

PointScatter scatter_of(std::size_t measurement, const CheckedRuns& runs, Eigen::Index value,
                        const SimulatedPoints& simulated, const Plane& plane) {
  std::vector<results::TradeoffValue> over_seeds;
  double inverse = 0;  // of the number of seeds, mean over the points
  for (const std::size_t point : runs.points) {
    const Sample found =
        simulated.outcomes[point].over_seeds(measurement, runs.places[static_cast<std::size_t>(value)]);
    over_seeds.push_back({found.mean, found.scatter, found.count, 0});
    inverse += 1 / static_cast<double>(found.count * runs.points.size());
  }
  const PooledScatter pooled = pooled_scatter(over_seeds, 1);
  if (pooled.freedom > 0) return {pooled.scatter * pooled.scatter * inverse, pooled.freedom};
  const auto freedom = static_cast<double>(plane.places.rows() - plane.places.cols());
  const Eigen::VectorXd off = plane.values.col(value) - plane.places * plane.coefficients.col(value);
  return {off.squaredNorm() / freedom, freedom};
}

/// Whether one of the values changes with the parameters by more than chance explains: in 10 % of cases for
/// all values together (F). A slope by chance would be worth as much as a true one.
bool changes_with_parameters(std::size_t measurement, const CheckedRuns& runs,
                             const SimulatedPoints& simulated, const Plane& plane) {
  constexpr double kSlopeByChance = 0.1;
  const auto slopes = static_cast<double>(plane.places.cols() - 1);
  for (Eigen::Index q = 0; q < plane.values.cols(); ++q) {
    const PointScatter scatter = scatter_of(measurement, runs, q, simulated, plane);
    const Eigen::VectorXd fitted = plane.places * plane.coefficients.col(q);
    const double explained = (fitted.array() - plane.values.col(q).mean()).square().sum() / slopes;
    const double ratio = results::variance_ratio_exceeded(
        slopes, scatter.freedom, kSlopeByChance / static_cast<double>(plane.values.cols()));
    if (explained > ratio * scatter.variance) return true;
  }
  return false;
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
    const std::string unknown =
        "what \"" + measurement.name + "\" would add to the fit is not estimated: it ";
    if (runs.points.size() <= plan.parameters.size() + 1) {
      account.remarks.push_back(unknown + "was run for " + std::to_string(runs.points.size()) +
                                " sets of parameters, at least " +
                                std::to_string(plan.parameters.size() + 2) + " are needed");
      continue;
    }
    const Plane plane = plane_through(m, runs, simulated, samples.cols());
    if (changes_with_parameters(m, runs, simulated, plane))
      possible.push_back(
          {measurement.name + ", used to fit", plane.at(samples), deviations_at(measurement, runs.places)});
    else
      account.remarks.push_back(unknown +
                                "changes over the powders that agree by no more than chance explains (10 %); "
                                "more seeds would tell");
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
