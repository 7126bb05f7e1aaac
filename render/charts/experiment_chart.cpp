#include "render/charts/experiment_chart.h"

#include <limits>

namespace diefill::render {

namespace {

ChartAxis axis_of(const results::ExperimentAxis& axis) {
  return {.label = axis.label, .lower = axis.lower, .upper = axis.upper, .logarithmic = axis.logarithmic};
}

/// An axis that is to begin at 0 begins with the values instead where some are negative: no point is cut off.
ChartAxis value_axis_of(const results::ExperimentChart& chart) {
  ChartAxis axis = axis_of(chart.y);
  if (axis.lower != 0) return axis;
  for (const auto& series : chart.series)
    for (const double value : series.y)
      if (value < 0) axis.lower = std::numeric_limits<double>::quiet_NaN();
  return axis;
}

CurveStyle style_of(results::ExperimentSeries::Role role) {
  using Role = results::ExperimentSeries::Role;
  if (role == Role::measured) return CurveStyle::kLineAndMarkers;
  return role == Role::predicted ? CurveStyle::kLine : CurveStyle::kMarkers;
}

/// The scatter as error bars, round a dense curve as a band.
Curve curve_of(const results::ExperimentSeries& series) {
  constexpr std::size_t kMostBars = 40;
  Curve curve = {.name = series.in_legend ? series.name : "",
                 .x = series.x,
                 .y = series.y,
                 .style = style_of(series.role),
                 .y_error = {}};
  (series.y_scatter.size() > kMostBars ? curve.band : curve.y_error) = series.y_scatter;
  return curve;
}

}  // namespace

Chart chart_of(const results::ExperimentChart& chart) {
  Chart drawn;
  drawn.title = chart.title;
  drawn.subtitle = chart.subtitle;
  drawn.note = chart.note;
  drawn.x = axis_of(chart.x);
  drawn.y = value_axis_of(chart);
  for (const auto& series : chart.series) drawn.curves.push_back(curve_of(series));
  return drawn;
}

std::filesystem::path draw_experiment(const std::filesystem::path& directory,
                                      const results::ExperimentChart& chart) {
  const auto png = directory / (chart.name + ".png");
  draw_chart(png, chart_of(chart));
  return png;
}

}  // namespace diefill::render
