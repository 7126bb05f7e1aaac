#include "render/report/sections/calibration_data_section.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/results/rounding.h"
#include "render/report/numbers.h"
#include "render/report/pictures_of.h"

namespace diefill::render::report {
namespace {

constexpr std::size_t kMaxListed = 12;  // values of a measurement that are listed one by one

/// Measured values with their deviations, simulated ones with the region's range.
Figure curve_picture(const results::CalibratedMeasurement& measurement) {
  Chart chart;
  chart.title = measurement.name;
  chart.subtitle = measurement.fitted ? "fitted" : "kept for checking";
  chart.x.label = with_unit_of(measurement.x_name, measurement.x_unit);
  chart.y.label = with_unit_of(measurement.quantity, measurement.unit);
  Curve measured{"measured", {}, {}, CurveStyle::kMarkers, {}},
      best{"simulated, best powder", {}, {}, CurveStyle::kLineAndMarkers, {}};
  Curve lower{"simulated, 90 % of powders that agree", {}, {}, CurveStyle::kLine, {}};
  for (const auto& datum : measurement.data) {
    for (Curve* curve : {&measured, &best, &lower}) curve->x.push_back(datum.x);
    measured.y.push_back(datum.measured);
    measured.y_error.push_back(datum.deviation);
    best.y.push_back(datum.simulated);
    best.y_error.push_back(datum.scatter);  // NaN, no bar, where it is not known
    lower.y.push_back(0.5 * (datum.lower + datum.upper));
    lower.band.push_back(0.5 * (datum.upper - datum.lower));
  }
  chart.curves = {lower, best, measured};  // measured on top
  chart.note =
      "Bars: standard deviation of the measurement, and of one run over seeds; band: over powders that agree";
  return chart_picture(chart, measurement.name + ": measured and simulated");
}

Table data_table(const results::Calibration& calibration, bool fitted) {
  Table table{"",
              {"Measurement", "Measured", "Simulated", "Over powders that agree", "Scatter over seeds",
               "Difference in deviations", "With finer grains"},
              {},
              true};
  for (const auto& measurement : calibration.measurements) {
    if (measurement.fitted != fitted || measurement.data.size() > kMaxListed) continue;
    for (const auto& datum : measurement.data) {
      const std::string unit = results::unit_behind(measurement.unit);
      const std::string at = std::isfinite(datum.x)
                                 ? " at " + in_digits(datum.x, 3) + results::unit_behind(measurement.x_unit)
                                 : "";
      const double own = std::isfinite(datum.uncertainty) ? datum.uncertainty : 0;
      const auto in_unit = [&](double value, int digits) {
        return in_digits(value, digits) + (std::isfinite(value) ? unit : "");
      };
      table.rows.push_back(
          {measurement.name + at, in_digits(datum.measured, 4) + " ± " + in_digits(datum.deviation, 2) + unit,
           in_unit(datum.simulated, 4), in_digits(datum.lower, 4) + " to " + in_digits(datum.upper, 4) + unit,
           in_unit(datum.scatter, 2),
           in_digits((datum.simulated - datum.measured) / std::hypot(datum.deviation, own), 2),
           std::isfinite(datum.finer) ? in_digits(datum.finer, 4) + unit : "–"});
    }
  }
  leave_out_empty_columns(table);
  return table;
}

}  // namespace

Figure agreement_picture(const results::CalibratedMeasurement& measurement) {
  Chart chart;
  chart.title = measurement.name + ": " + measurement.quantity;
  chart.subtitle = measurement.fitted ? "fitted" : "kept for checking";
  chart.x.label = with_unit_of("Measured", measurement.unit);
  chart.y.label = with_unit_of("Simulated", measurement.unit);
  Curve places{"a place of the map", {}, {}, CurveStyle::kMarkers, {}};
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const auto& datum : measurement.data) {
    if (!std::isfinite(datum.simulated)) continue;
    places.x.push_back(datum.measured);
    places.y.push_back(datum.simulated);
    least = std::min({least, datum.measured, datum.simulated});
    most = std::max({most, datum.measured, datum.simulated});
  }
  if (!places.x.empty())
    chart.curves.push_back({"equal", {least, most}, {least, most}, CurveStyle::kReference, {}});
  chart.curves.push_back(std::move(places));
  chart.note = "Best powder; " + std::to_string(measurement.data.size()) + " places were measured";
  return chart_picture(chart, measurement.name + ": simulated over measured");
}

Section measured_and_simulated(const results::Calibration& calibration, bool fitted) {
  Section section{fitted ? "Measured and simulated" : "Check on what was not fitted", 1, {}};
  if (const Table table = data_table(calibration, fitted); !table.rows.empty())
    section.blocks.emplace_back(table);
  if (!calibration.finer_grains.empty() && fitted)
    section.blocks.emplace_back(
        Paragraph{"Finer grains: d = " + calibration.finer_grains + ", at the best parameters.", false});
  Figures figures;
  for (const auto& measurement : calibration.measurements) {
    if (measurement.fitted != fitted) continue;
    if (!measurement.remark.empty())
      section.blocks.emplace_back(Paragraph{measurement.name + ": " + measurement.remark + '.', true});
    const std::string residual = std::isfinite(measurement.residual)
                                     ? "; mean square perpendicular distance from the measured curve " +
                                           in_digits(measurement.residual, 2) + " (Bierwisch 2009, Eq. 4.3)"
                                     : "";
    section.blocks.emplace_back(
        Paragraph{measurement.name + ": chi^2 " + in_digits(measurement.chi_square, 3) + " of " +
                      std::to_string(measurement.data.size()) +
                      (measurement.data.size() == 1 ? " value" : " values") + residual + '.',
                  false});
    if (!measurement.x_name.empty() && measurement.second_name.empty() && measurement.data.size() > 1)
      figures.figures.push_back(curve_picture(measurement));
    if (!measurement.second_name.empty() && measurement.data.size() > kMaxListed)
      figures.figures.push_back(agreement_picture(measurement));
  }
  if (!figures.figures.empty()) section.blocks.emplace_back(std::move(figures));
  return section;
}

}  // namespace diefill::render::report
