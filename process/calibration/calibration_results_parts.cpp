// Parameters, measurements and maps of a calibration's account.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/calibration/calibration_results.h"
#include "process/calibration/methods/curve_residual.h"
#include "process/input/units.h"

namespace diefill::process::calibration {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kProfilePlaces = 31, kMapNodes = 31, kMapNodesOfMany = 15;
constexpr Eigen::Index kKeptSamples = 200;

/// Mean and standard deviation of a quantity over a point's seeds.
struct OverSeeds {
  double mean = kNone, scatter = kNone;
};

OverSeeds over_seeds(const std::vector<std::vector<double>>& rows, std::size_t quantity) {
  OverSeeds found;
  if (rows.empty()) return found;
  const double count = static_cast<double>(rows.size());
  found.mean = 0;
  for (const auto& row : rows) found.mean += row[quantity] / count;
  if (rows.size() < 2) return found;
  double squares = 0;
  for (const auto& row : rows) squares += std::pow(row[quantity] - found.mean, 2);
  found.scatter = std::sqrt(squares / (count - 1));
  return found;
}

/// Name, units and measured values.
results::CalibratedMeasurement measured(const Measurement& measurement) {
  results::CalibratedMeasurement row;
  row.name = measurement.name;
  row.kind = measurement.kind;
  row.fitted = measurement.fitted;
  row.quantity = measurement.quantity;
  row.unit = measurement.data.value.unit;
  row.chi_square = row.residual = row.left_out_error = kNone;
  const auto& places = measurement.data.places;
  if (!places.empty()) {
    row.x_name = places[0].name;
    row.x_unit = places[0].unit;
  }
  if (places.size() > 1) {
    row.second_name = places[1].name;
    row.second_unit = places[1].unit;
  }
  for (std::size_t k = 0; k < measurement.data.size(); ++k)
    row.data.push_back({places.empty() ? kNone : places[0].values[k],
                        places.size() > 1 ? places[1].values[k] : kNone, measurement.data.value.values[k],
                        measurement.data.deviation.values[k], kNone, kNone, kNone, kNone, kNone});
  return row;
}

/// Least and largest of a region's predictions that hold 90 %.
void add_range(results::CalibratedMeasurement& row, const Emulator& emulator, const Region& region) {
  std::vector<std::vector<double>> values(row.data.size());
  const Eigen::Index step = std::max<Eigen::Index>(1, region.samples.rows() / 300);
  for (Eigen::Index k = 0; k < region.samples.rows(); k += step) {
    const auto mean = emulator.at(region.samples.row(k).transpose()).mean;
    for (std::size_t q = 0; q < values.size(); ++q) values[q].push_back(mean[static_cast<Eigen::Index>(q)]);
  }
  for (std::size_t q = 0; q < values.size(); ++q) {
    std::sort(values[q].begin(), values[q].end());
    row.data[q].lower = values[q][values[q].size() / 20];
    row.data[q].upper = values[q][values[q].size() - 1 - values[q].size() / 20];
  }
}

/// Values that lie further beyond all that was simulated than three standard deviations.
std::string out_of_reach(const results::CalibratedMeasurement& row, std::size_t measurement,
                         const SimulatedPoints& simulated) {
  std::size_t beyond = 0, first = 0;
  double least_of_first = 0, most_of_first = 0;
  for (std::size_t q = 0; q < row.data.size(); ++q) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
      if (simulated.points[k].role == "finer") continue;
      for (const auto& values : simulated.outcomes[k].values[measurement]) {
        least = std::min(least, values[q]);
        most = std::max(most, values[q]);
      }
    }
    const double reach = 3 * row.data[q].deviation;
    if (!(row.data[q].measured < least - reach || row.data[q].measured > most + reach)) continue;
    if (beyond++ > 0) continue;
    first = q;
    least_of_first = least;
    most_of_first = most;
  }
  if (beyond == 0) return {};
  return "no parameters in these ranges reach " + std::to_string(beyond) + " of its " +
         std::to_string(row.data.size()) + " values: measured " + number_text(row.data[first].measured) +
         ' ' + row.unit + ", simulated " + number_text(least_of_first) + " to " + number_text(most_of_first);
}

void add_residual(results::CalibratedMeasurement& row, const Measurement& measurement) {
  if (!measurement.is_curve() || measurement.data.size() < 2) return;
  std::vector<double> simulated;
  for (const auto& datum : row.data) simulated.push_back(datum.simulated);
  try {
    const MeasuredCurve curve =
        curve_through(measurement.data.places[0].values, measurement.data.value.values);
    row.residual = mean_square_residual(curve, curve.x, simulated);
  } catch (const std::invalid_argument&) {
    row.residual = kNone;  // a curve that is zero everywhere
  }
}

void add_fitted(results::CalibratedMeasurement& row, const MeasuredData& data, const Region& region) {
  const auto there = data.emulator->at(region.best);
  const Eigen::VectorXd scatter = data.emulator->scatter();
  for (std::size_t q = 0; q < row.data.size(); ++q) {
    const auto at = static_cast<Eigen::Index>(q);
    row.data[q].simulated = there.mean[at];
    row.data[q].uncertainty = std::sqrt(there.factor * data.emulator->covariance()(at, at));
    row.data[q].scatter = scatter[at];
  }
  row.left_out_error = data.emulator->left_out_error();
  row.chi_square = Likelihood({data}).chi_square(region.best);
  add_range(row, *data.emulator, region);
}

/// From the runs at the best parameters and at the region's edge.
void add_checked(results::CalibratedMeasurement& row, std::size_t measurement,
                 const SimulatedPoints& simulated) {
  row.chi_square = 0;
  for (std::size_t q = 0; q < row.data.size(); ++q) {
    auto& datum = row.data[q];
    for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
      const auto& rows = simulated.outcomes[k].values[measurement];
      const OverSeeds found = over_seeds(rows, q);
      if (rows.empty() || simulated.points[k].role == "finer") continue;
      datum.lower = std::isfinite(datum.lower) ? std::min(datum.lower, found.mean) : found.mean;
      datum.upper = std::isfinite(datum.upper) ? std::max(datum.upper, found.mean) : found.mean;
      if (simulated.points[k].role != "best") continue;
      datum.simulated = found.mean;
      datum.scatter = found.scatter;
      datum.uncertainty = found.scatter / std::sqrt(static_cast<double>(rows.size()));
    }
    const double own = std::isfinite(datum.uncertainty) ? datum.uncertainty : 0;
    row.chi_square +=
        std::pow(datum.simulated - datum.measured, 2) / (datum.deviation * datum.deviation + own * own);
  }
}

/// Of the runs with finer grains.
void add_finer(results::CalibratedMeasurement& row, std::size_t measurement,
               const SimulatedPoints& simulated) {
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k)
    if (simulated.points[k].role == "finer")
      for (std::size_t q = 0; q < row.data.size(); ++q)
        row.data[q].finer = over_seeds(simulated.outcomes[k].values[measurement], q).mean;
}

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

/// chi^2 with two parameters held, least over the others.
double least_chi_square(const Likelihood& likelihood, const Eigen::VectorXd& best, Eigen::Index i,
                        Eigen::Index j, double at_i, double at_j) {
  Eigen::VectorXd place = best;
  place[i] = at_i;
  place[j] = at_j;
  if (best.size() == 2) return likelihood.chi_square(place);
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < best.size(); ++d)
    if (d != i && d != j) free.push_back(d);
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::VectorXd start(count);
  for (Eigen::Index k = 0; k < count; ++k) start[k] = best[free[static_cast<std::size_t>(k)]];
  const auto objective = [&](const Eigen::VectorXd& others) {
    for (Eigen::Index k = 0; k < count; ++k) place[free[static_cast<std::size_t>(k)]] = others[k];
    return likelihood.chi_square(place);
  };
  return minimum_near(objective, start, Eigen::VectorXd::Zero(count), Eigen::VectorXd::Ones(count), 40).value;
}

/// epsilon^2 of a curve over two parameters, all others at their best.
results::Field2D curve_map(const Measurement& measurement, const Emulator& emulator,
                           const Eigen::VectorXd& best, const CalibrationPlan& plan, std::size_t i,
                           std::size_t j) {
  const MeasuredCurve curve = curve_through(measurement.data.places[0].values, measurement.data.value.values);
  const auto residual = [&](double a, double b) {
    Eigen::VectorXd place = best;
    place[static_cast<Eigen::Index>(i)] = place_at(plan.parameters[i], a);
    place[static_cast<Eigen::Index>(j)] = place_at(plan.parameters[j], b);
    const auto mean = emulator.at(place).mean;
    return std::sqrt(mean_square_residual(curve, curve.x, {mean.begin(), mean.end()}));
  };
  return residual_map("perpendicular residual of " + measurement.name, axis_of(plan.parameters[i], kMapNodes),
                      axis_of(plan.parameters[j], kMapNodes), residual);
}

}  // namespace

void add_parameters(results::Calibration& account, const CalibrationPlan& plan,
                    const std::optional<Fit>& fit) {
  const std::size_t count = plan.parameters.size();
  std::vector<std::vector<ProfilePoint>> along;
  if (fit)
    along = profiles([&](const Eigen::VectorXd& at) { return fit->likelihood->chi_square(at); },
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
  const Eigen::Index step = std::max<Eigen::Index>(1, fit->region.samples.rows() / kKeptSamples);
  for (Eigen::Index s = 0; s < fit->region.samples.rows(); s += step) {
    std::vector<double> sample;
    for (std::size_t k = 0; k < count; ++k)
      sample.push_back(plan.parameters[k].value_at(fit->region.samples(s, static_cast<Eigen::Index>(k))));
    account.samples.push_back(std::move(sample));
  }
}

void add_measurements(results::Calibration& account, const CalibrationPlan& plan,
                      const SimulatedPoints& simulated, const std::optional<Fit>& fit) {
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    results::CalibratedMeasurement row = measured(plan.measurements[m]);
    if (fit && row.fitted) {
      const auto found = std::find(fit->measurement.begin(), fit->measurement.end(), m);
      add_fitted(row,
                 fit->likelihood->measurements()[static_cast<std::size_t>(found - fit->measurement.begin())],
                 fit->region);
      row.remark = out_of_reach(row, m, simulated);
    } else if (fit) {
      add_checked(row, m, simulated);
    }
    if (fit) add_residual(row, plan.measurements[m]);
    add_finer(row, m, simulated);
    account.measurements.push_back(std::move(row));
  }
}

void add_maps(results::Calibration& account, const CalibrationPlan& plan, const Fit& fit) {
  const std::size_t count = plan.parameters.size();
  const int nodes = count == 2 ? kMapNodes : kMapNodesOfMany;
  const double data = static_cast<double>(fit.likelihood->data());
  // chi^2 of two parameters exceeds its least value by -2 ln(1 - share) at the edge of what holds the share.
  account.map_edge = std::sqrt((account.chi_square - 2 * std::log(1 - fit.region.share)) / data);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto residual = [&](double a, double b) {
        const double chi = least_chi_square(*fit.likelihood, fit.region.best, static_cast<Eigen::Index>(i),
                                            static_cast<Eigen::Index>(j), place_at(plan.parameters[i], a),
                                            place_at(plan.parameters[j], b));
        return std::sqrt(chi / data);
      };
      account.maps.push_back(residual_map("misfit in standard deviations", axis_of(plan.parameters[i], nodes),
                                          axis_of(plan.parameters[j], nodes), residual));
    }
  if (count < 2) return;
  for (std::size_t k = 0; k < fit.measurement.size(); ++k) {
    const Measurement& measurement = plan.measurements[fit.measurement[k]];
    if (!measurement.is_curve() || measurement.data.size() < 2) continue;
    if (std::all_of(measurement.data.value.values.begin(), measurement.data.value.values.end(),
                    [](double value) { return value == 0; }))
      continue;
    account.residual_maps.push_back(
        curve_map(measurement, *fit.likelihood->measurements()[k].emulator, fit.region.best, plan, 0, 1));
  }
}

}  // namespace diefill::process::calibration
