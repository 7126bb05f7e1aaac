#include "process/calibration/fit.h"

namespace diefill::process::calibration {
namespace {

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The emulator of a measurement; nothing where too few points have values.
std::shared_ptr<const Emulator> emulator_of(std::size_t measurement, const SimulatedPoints& simulated,
                                            std::size_t dimensions) {
  std::vector<std::pair<std::size_t, std::size_t>> rows;  // point, seed
  std::size_t with_values = 0;
  for (std::size_t k = 0; k < simulated.points.size(); ++k) {
    const auto& values = simulated.outcomes[k].values[measurement];
    with_values += values.empty() ? 0 : 1;
    for (std::size_t s = 0; s < values.size(); ++s) rows.emplace_back(k, s);
  }
  if (with_values < dimensions + 2) return nullptr;
  const std::size_t quantities = simulated.outcomes[rows.front().first].values[measurement].front().size();
  Eigen::MatrixXd inputs(rows.size(), dimensions), outputs(rows.size(), quantities);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto [point, seed] = rows[r];
    inputs.row(static_cast<Eigen::Index>(r)) = vector_of(simulated.points[point].place).transpose();
    outputs.row(static_cast<Eigen::Index>(r)) =
        vector_of(simulated.outcomes[point].values[measurement][seed]).transpose();
  }
  return std::make_shared<Emulator>(inputs, outputs);
}

}  // namespace

std::optional<Fit> fit_points(const CalibrationPlan& plan, const SimulatedPoints& simulated) {
  Fit fit;
  std::vector<MeasuredData> data;
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (!measurement.fitted) continue;
    auto emulator = emulator_of(m, simulated, plan.parameters.size());
    if (!emulator) return std::nullopt;
    fit.measurement.push_back(m);
    data.push_back({vector_of(measurement.data.value.values), vector_of(measurement.data.deviation.values),
                    std::move(emulator)});
  }
  fit.likelihood = std::make_shared<Likelihood>(std::move(data));
  fit.region = sample_region([&](const Eigen::VectorXd& at) { return fit.likelihood->log_at(at); },
                             static_cast<Eigen::Index>(plan.parameters.size()), plan.seed);
  return fit;
}

}  // namespace diefill::process::calibration
