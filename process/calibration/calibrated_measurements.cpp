// Measurements of a calibration's account: measured against simulated, at the best parameters and over the
// powders that agree.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/calibration/calibration_results.h"
#include "process/input/units.h"
#include "process/measured_data/deviations.h"
#include "process/results/none.h"
#include "process/tradeoff/evaluate.h"

namespace diefill::process::calibration {
namespace {

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
void add_range(results::CalibratedMeasurement& row, const std::vector<std::size_t>& places,
               const Emulator& emulator, const Region& region) {
  std::vector<std::vector<double>> values(places.size());
  const Eigen::Index step = std::max<Eigen::Index>(1, region.samples.rows() / 300);
  for (Eigen::Index k = 0; k < region.samples.rows(); k += step) {
    const auto mean = emulator.at(region.samples.row(k).transpose()).mean;
    for (std::size_t q = 0; q < values.size(); ++q) values[q].push_back(mean[static_cast<Eigen::Index>(q)]);
  }
  for (std::size_t q = 0; q < values.size(); ++q) {
    std::sort(values[q].begin(), values[q].end());
    row.data[places[q]].lower = values[q][values[q].size() / 20];
    row.data[places[q]].upper = values[q][values[q].size() - 1 - values[q].size() / 20];
  }
}

/// Least and largest value of all runs but those with finer grains.
struct Reached {
  double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
};

Reached reached(std::size_t measurement, std::size_t place, const SimulatedPoints& simulated) {
  Reached all;
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
    if (simulated.points[k].role == "finer") continue;
    for (const auto& values : simulated.outcomes[k].values[measurement]) {
      if (!std::isfinite(values[place])) continue;
      all.least = std::min(all.least, values[place]);
      all.most = std::max(all.most, values[place]);
    }
  }
  return all;
}

/// Values that lie further beyond all that was simulated than three standard deviations.
std::string out_of_reach(const results::CalibratedMeasurement& row, const std::vector<std::size_t>& places,
                         std::size_t measurement, const SimulatedPoints& simulated) {
  std::size_t beyond = 0;
  std::string first;
  for (const std::size_t q : places) {
    const auto& datum = row.data[q];
    const Reached all = reached(measurement, q, simulated);
    const double reach = 3 * datum.deviation;
    if (!(datum.measured < all.least - reach || datum.measured > all.most + reach)) continue;
    if (beyond++ > 0) continue;
    first = "measured " + number_text(datum.measured) + ' ' + row.unit + ", simulated " +
            number_text(all.least) + " to " + number_text(all.most);
  }
  if (beyond == 0) return {};
  return "no parameters in these ranges reach " + std::to_string(beyond) + " of its " +
         std::to_string(row.data.size()) + " values: " + first;
}

/// One more statement of a remark, whose first one may be empty.
void add_remark(std::string& remark, const std::string& statement) {
  if (!statement.empty()) remark += (remark.empty() ? "" : "; ") + statement;
}

/// What stands beside a fitted measurement: places left out, values out of reach.
std::string remark_on(const results::CalibratedMeasurement& row, const std::vector<std::size_t>& places,
                      std::size_t measurement, const SimulatedPoints& simulated) {
  std::string remark = out_of_reach(row, places, measurement, simulated);
  if (const std::size_t left_out = row.data.size() - places.size(); left_out > 0)
    add_remark(remark, std::to_string(left_out) + " of its " + std::to_string(row.data.size()) +
                           " values are left out: most runs have values elsewhere, but not there");
  return remark;
}

void add_residual(results::CalibratedMeasurement& row, const Measurement& measurement) {
  std::vector<std::size_t> places;
  std::vector<double> simulated;
  for (std::size_t q = 0; q < row.data.size(); ++q)
    if (std::isfinite(row.data[q].simulated)) {
      places.push_back(q);
      simulated.push_back(row.data[q].simulated);
    }
  if (const auto curve = measured_curve(measurement, places))
    row.residual = mean_square_residual(*curve, curve->x, simulated);
}

void add_fitted(results::CalibratedMeasurement& row, const std::vector<std::size_t>& places,
                const MeasuredData& data, const Region& region) {
  const auto there = data.emulator->at(region.best);
  const Eigen::VectorXd scatter = data.emulator->scatter();
  for (std::size_t q = 0; q < places.size(); ++q) {
    const auto at = static_cast<Eigen::Index>(q);
    auto& datum = row.data[places[q]];
    datum.simulated = there.mean[at];
    datum.uncertainty = std::sqrt(there.factor * data.emulator->covariance()(at, at));
    datum.scatter = scatter[at];
  }
  row.left_out_error = data.emulator->left_out_error();
  row.chi_square = Likelihood({data}).chi_square(region.best);
  add_range(row, places, *data.emulator, region);
}

/// One value from the runs at the best parameters and at the region's edge, over all of which the scatter
/// over seeds is pooled: two seeds alone hardly tell it.
void add_checked_value(results::CalibrationDatum& datum, std::size_t measurement, std::size_t place,
                       const SimulatedPoints& simulated) {
  std::vector<results::TradeoffValue> over_seeds;
  std::size_t seeds = 0;  // of the best parameters
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k) {
    const Sample found = simulated.outcomes[k].over_seeds(measurement, place);
    if (found.count == 0 || simulated.points[k].role == "finer") continue;
    datum.lower = std::fmin(datum.lower, found.mean);  // also where there was none (NaN)
    datum.upper = std::fmax(datum.upper, found.mean);
    over_seeds.push_back({found.mean, found.scatter, found.count, kNone});
    if (simulated.points[k].role != "best") continue;
    datum.simulated = found.mean;
    seeds = found.count;
  }
  const PooledScatter pooled = pooled_scatter(over_seeds, 1);
  datum.scatter = pooled.scatter;
  datum.freedom = pooled.freedom;
  if (seeds > 0) datum.uncertainty = pooled.scatter / std::sqrt(static_cast<double>(seeds));
}

void add_checked(results::CalibratedMeasurement& row, std::size_t measurement,
                 const SimulatedPoints& simulated) {
  for (std::size_t q = 0; q < row.data.size(); ++q) add_checked_value(row.data[q], measurement, q, simulated);
  row.chi_square = chi_square_of_check(row, CheckedAgainst::deviation);
}

/// Of the runs with finer grains.
void add_finer(results::CalibratedMeasurement& row, std::size_t measurement,
               const SimulatedPoints& simulated) {
  for (std::size_t k = 0; k < simulated.outcomes.size(); ++k)
    if (simulated.points[k].role == "finer")
      for (std::size_t q = 0; q < row.data.size(); ++q)
        row.data[q].finer = simulated.outcomes[k].over_seeds(measurement, q).mean;
}

}  // namespace

void add_measurements(results::Calibration& account, const CalibrationPlan& plan,
                      const SimulatedPoints& simulated, const std::optional<Fit>& fit) {
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    results::CalibratedMeasurement row = measured(plan.measurements[m]);
    if (fit && row.fitted) {
      const auto k = static_cast<std::size_t>(std::find(fit->measurement.begin(), fit->measurement.end(), m) -
                                              fit->measurement.begin());
      add_fitted(row, fit->places[k], fit->likelihood->measurements()[k], fit->region);
      row.remark = remark_on(row, fit->places[k], m, simulated);
    } else if (fit) {
      add_checked(row, m, simulated);
    }
    add_remark(row.remark, remark_on_deviations(plan.measurements[m].data));
    if (fit) add_residual(row, plan.measurements[m]);
    add_finer(row, m, simulated);
    account.measurements.push_back(std::move(row));
  }
}

}  // namespace diefill::process::calibration
