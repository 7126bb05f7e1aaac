#include "process/calibration/fit.h"

#include <algorithm>
#include <cmath>

namespace diefill::process::calibration {
namespace {

constexpr double kMostRuns = 0.8;  // share of the runs: a place that fewer have is left out, not the others

/// The runs and values of a measurement that its emulator is made of.
struct ChosenRuns {
  std::vector<std::size_t> places;                        ///< which of the measurement's values
  std::vector<std::pair<std::size_t, std::size_t>> rows;  ///< point, seed
  std::size_t points = 0;
};

/// Values that most of the runs have which have any; at least those that most have.
std::vector<std::size_t> places_in_most_runs(std::size_t measurement, const SimulatedPoints& simulated) {
  std::vector<std::size_t> runs_with;
  double runs = 0;
  for (const PointOutcome& outcome : simulated.outcomes)
    for (const auto& row : outcome.values[measurement]) {
      runs += 1;
      runs_with.resize(row.size());
      for (std::size_t q = 0; q < row.size(); ++q) runs_with[q] += std::isfinite(row[q]) ? 1 : 0;
    }
  std::vector<std::size_t> places;
  if (runs_with.empty()) return places;
  const double most = static_cast<double>(*std::max_element(runs_with.begin(), runs_with.end()));
  for (std::size_t q = 0; q < runs_with.size(); ++q)
    if (static_cast<double>(runs_with[q]) >= std::min(most, kMostRuns * runs)) places.push_back(q);
  return places;
}

ChosenRuns chosen_runs(std::size_t measurement, const SimulatedPoints& simulated) {
  ChosenRuns chosen;
  chosen.places = places_in_most_runs(measurement, simulated);
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
    const auto& values = simulated.outcomes[k].values[measurement];
    const std::size_t before = chosen.rows.size();
    for (std::size_t s = 0; s < values.size(); ++s)
      if (std::all_of(chosen.places.begin(), chosen.places.end(),
                      [&](std::size_t q) { return std::isfinite(values[s][q]); }))
        chosen.rows.emplace_back(k, s);
    chosen.points += chosen.rows.size() > before ? 1 : 0;
  }
  return chosen;
}

std::size_t points_needed(const CalibrationPlan& plan) {
  return plan.parameters.size() + 2;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::VectorXd values_at(const std::vector<double>& values, const std::vector<std::size_t>& places) {
  Eigen::VectorXd chosen(static_cast<Eigen::Index>(places.size()));
  for (std::size_t q = 0; q < places.size(); ++q) chosen[static_cast<Eigen::Index>(q)] = values[places[q]];
  return chosen;
}

std::shared_ptr<const Emulator> emulator_of(std::size_t measurement, const SimulatedPoints& simulated,
                                            const ChosenRuns& chosen, std::size_t dimensions) {
  Eigen::MatrixXd inputs(chosen.rows.size(), dimensions), outputs(chosen.rows.size(), chosen.places.size());
  for (std::size_t r = 0; r < chosen.rows.size(); ++r) {
    const auto [point, seed] = chosen.rows[r];
    inputs.row(static_cast<Eigen::Index>(r)) = vector_of(simulated.points[point].place).transpose();
    outputs.row(static_cast<Eigen::Index>(r)) =
        values_at(simulated.outcomes[point].values[measurement][seed], chosen.places).transpose();
  }
  return std::make_shared<Emulator>(inputs, outputs);
}

}  // namespace

std::optional<Fit> fit_points(const CalibrationPlan& plan, const SimulatedPoints& simulated) {
  if (!why_no_fit(plan, simulated).empty()) return std::nullopt;
  Fit fit;
  std::vector<MeasuredData> data;
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (!measurement.fitted) continue;
    const ChosenRuns chosen = chosen_runs(m, simulated);
    fit.measurement.push_back(m);
    fit.places.push_back(chosen.places);
    data.push_back({values_at(measurement.data.value.values, chosen.places),
                    values_at(measurement.data.deviation.values, chosen.places),
                    emulator_of(m, simulated, chosen, plan.parameters.size())});
  }
  fit.likelihood = std::make_shared<Likelihood>(std::move(data));
  fit.region = sample_region([&](const Eigen::VectorXd& at) { return fit.likelihood->log_at(at); },
                             static_cast<Eigen::Index>(plan.parameters.size()), plan.seed);
  return fit;
}

std::string why_no_fit(const CalibrationPlan& plan, const SimulatedPoints& simulated) {
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    if (!plan.measurements[m].fitted) continue;
    const std::size_t points = chosen_runs(m, simulated).points;
    if (points < points_needed(plan))
      return "too few runs gave values of \"" + plan.measurements[m].name + "\": " + std::to_string(points) +
             " sets of parameters have them, at least " + std::to_string(points_needed(plan)) + " are needed";
  }
  return {};
}

}  // namespace diefill::process::calibration
