// Parameters and maps of a calibration's account.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "process/calibration/calibration_results.h"
#include "process/results/none.h"

namespace diefill::process::calibration {
namespace {

constexpr int kProfilePlaces = 31, kMapNodes = 31, kMapNodesOfMany = 15;
constexpr Eigen::Index kKeptSamples = 200;

/// The axis of a map along a parameter; logarithmic ranges run along their logarithm.
MapAxis axis_of(const ParameterRange& range, int nodes) {
  constexpr std::size_t kRoom = 20;  // letters that a label has room for
  const std::string name = range.key.size() > kRoom ? range.key.substr(range.key.rfind('.') + 1) : range.key;
  MapAxis axis{range.logarithmic ? "log10 of " + name : name, range.unit, {}};
  for (int k = 0; k < nodes; ++k) {
    const double value = range.value_at(static_cast<double>(k) / (nodes - 1));
    axis.nodes.push_back(range.logarithmic ? std::log10(value) : value);
  }
  return axis;
}

double place_at(const ParameterRange& range, double node) {
  return range.place_of(range.logarithmic ? std::pow(10, node) : node);
}

/// chi^2 of the best powder, and what -2 ln(likelihood) is above its least value at a place of the unit cube.
/// Unlike chi^2 itself it is no smaller where the emulators know little: it is least at the best powder, and
/// the region ends where it reaches one value.
double misfit_at(const Fit& fit, const Eigen::VectorXd& place) {
  const double above = 2 * (fit.region.best_log - fit.likelihood->log_at(place));
  return fit.likelihood->chi_square(fit.region.best) + std::max(0.0, above);
}

/// The same with two parameters held, least over the others.
double least_misfit(const Fit& fit, Eigen::Index i, Eigen::Index j, double at_i, double at_j) {
  const Eigen::VectorXd& best = fit.region.best;
  Eigen::VectorXd place = best;
  place[i] = at_i;
  place[j] = at_j;
  if (best.size() == 2) return misfit_at(fit, place);
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < best.size(); ++d)
    if (d != i && d != j) free.push_back(d);
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::VectorXd start(count);
  for (Eigen::Index k = 0; k < count; ++k) start[k] = best[free[static_cast<std::size_t>(k)]];
  const auto objective = [&](const Eigen::VectorXd& others) {
    for (Eigen::Index k = 0; k < count; ++k) place[free[static_cast<std::size_t>(k)]] = others[k];
    return misfit_at(fit, place);
  };
  return minimum_near(objective, start, Eigen::VectorXd::Zero(count), Eigen::VectorXd::Ones(count), 40).value;
}

/// epsilon^2 of a curve over two parameters, all others at their best.
results::Field2D curve_map(const std::string& name, const MeasuredCurve& curve, const Emulator& emulator,
                           const Eigen::VectorXd& best, const CalibrationPlan& plan, std::size_t i,
                           std::size_t j) {
  const auto residual = [&](double a, double b) {
    Eigen::VectorXd place = best;
    place[static_cast<Eigen::Index>(i)] = place_at(plan.parameters[i], a);
    place[static_cast<Eigen::Index>(j)] = place_at(plan.parameters[j], b);
    const auto mean = emulator.at(place).mean;
    return std::sqrt(mean_square_residual(curve, curve.x, {mean.begin(), mean.end()}));
  };
  return residual_map("perpendicular residual of " + name, axis_of(plan.parameters[i], kMapNodes),
                      axis_of(plan.parameters[j], kMapNodes), residual);
}

/// Powders that agree.
void add_samples(results::Calibration& account, const CalibrationPlan& plan, const Region& region) {
  const Eigen::Index step = std::max<Eigen::Index>(1, region.samples.rows() / kKeptSamples);
  for (Eigen::Index s = 0; s < region.samples.rows(); s += step) {
    std::vector<double> sample;
    for (std::size_t k = 0; k < plan.parameters.size(); ++k)
      sample.push_back(plan.parameters[k].value_at(region.samples(s, static_cast<Eigen::Index>(k))));
    account.samples.push_back(std::move(sample));
  }
}

}  // namespace

void add_parameters(results::Calibration& account, const CalibrationPlan& plan,
                    const std::optional<Fit>& fit) {
  const std::size_t count = plan.parameters.size();
  std::vector<std::vector<ProfilePoint>> along;
  if (fit)
    along = profiles([&](const Eigen::VectorXd& at) { return misfit_at(*fit, at); },
                     static_cast<Eigen::Index>(count), kProfilePlaces);
  for (std::size_t k = 0; k < count; ++k) {
    const ParameterRange& range = plan.parameters[k];
    results::CalibratedParameter row{range.key, range.unit, range.from, range.to, range.logarithmic,
                                     kNone,     kNone,      kNone,      {},       {}};
    if (fit) {
      const auto d = static_cast<Eigen::Index>(k);
      row.best = range.value_at(fit->region.best[d]);
      row.lower = range.value_at(fit->region.lower[d]);
      row.upper = range.value_at(fit->region.upper[d]);
      for (const ProfilePoint& point : along[k]) {
        row.profile_at.push_back(range.value_at(point.place));
        row.profile.push_back(point.value);
      }
    }
    account.parameters.push_back(std::move(row));
  }
  if (!fit) return;
  account.correlation.assign(count, std::vector<double>(count));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      account.correlation[i][j] =
          i == j ? 1 : fit->region.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  add_samples(account, plan, fit->region);
}

std::optional<MeasuredCurve> measured_curve(const Measurement& measurement,
                                            const std::vector<std::size_t>& places) {
  if (!measurement.is_curve()) return std::nullopt;
  std::vector<double> x, y;
  for (const std::size_t q : places) {
    x.push_back(measurement.data.places[0].values[q]);
    y.push_back(measurement.data.value.values[q]);
  }
  try {
    return curve_through(std::move(x), std::move(y));
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // too few points, or zero everywhere
  }
}

void add_maps(results::Calibration& account, const CalibrationPlan& plan, const Fit& fit) {
  const std::size_t count = plan.parameters.size();
  const int nodes = count == 2 ? kMapNodes : kMapNodesOfMany;
  const double data = static_cast<double>(fit.likelihood->data());
  account.map_edge =
      std::sqrt((account.chi_square + 2 * (fit.region.best_log - fit.region.threshold)) / data);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto residual = [&](double a, double b) {
        const double misfit = least_misfit(fit, static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j),
                                           place_at(plan.parameters[i], a), place_at(plan.parameters[j], b));
        return std::sqrt(misfit / data);
      };
      account.maps.push_back(residual_map("misfit in standard deviations", axis_of(plan.parameters[i], nodes),
                                          axis_of(plan.parameters[j], nodes), residual));
    }
  if (count < 2) return;
  for (std::size_t k = 0; k < fit.measurement.size(); ++k) {
    const Measurement& measurement = plan.measurements[fit.measurement[k]];
    if (const auto curve = measured_curve(measurement, fit.places[k]))
      account.residual_maps.push_back(curve_map(measurement.name, *curve,
                                                *fit.likelihood->measurements()[k].emulator, fit.region.best,
                                                plan, 0, 1));
  }
}

}  // namespace diefill::process::calibration
