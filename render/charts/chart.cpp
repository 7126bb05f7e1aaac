#include "render/charts/chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/charts/chart_layout.h"
#include "render/charts/curve_painter.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kWidth = 1600, kHeight = 1000;
constexpr double kUsualLegend = 126;  // pixels; a taller legend makes the picture taller
constexpr double kMargin = 36;
constexpr double kRightMargin = 64;  // half a tick label reaches beyond the data rectangle
constexpr int kXTicks = 9, kYTicks = 8;

std::vector<double> x_values(const Chart& chart) {
  std::vector<double> values;
  for (const auto& curve : chart.curves) {
    values.insert(values.end(), curve.x.begin(), curve.x.end());
    if (curve.style != CurveStyle::kBars || curve.x.size() < 2) continue;
    values.push_back(curve.x.front() - 0.5 * (curve.x[1] - curve.x[0]));
    values.push_back(curve.x.back() + 0.5 * (curve.x.back() - curve.x[curve.x.size() - 2]));
  }
  return values;
}

void add_air(std::vector<double>& values) {
  double lowest = INFINITY, highest = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  const double air = 0.02 * (highest - lowest);
  // Zero stays a limit: a mass or a count does not go below it.
  if (lowest != 0) values.push_back(lowest > 0 ? std::max(0.0, lowest - air) : lowest - air);
  if (highest != 0) values.push_back(highest < 0 ? std::min(0.0, highest + air) : highest + air);
}

// All heights, error bars included, and a little air on linear axes: a curve shall not run along the frame.
std::vector<double> y_values(const Chart& chart) {
  std::vector<double> values;
  for (const auto& curve : chart.curves) {
    values.insert(values.end(), curve.y.begin(), curve.y.end());
    for (std::size_t k = 0; k < curve.y_error.size(); ++k) {
      values.push_back(curve.y[k] - curve.y_error[k]);
      values.push_back(curve.y[k] + curve.y_error[k]);
    }
  }
  for (const auto& curve : chart.curves)
    for (std::size_t k = 0; k < curve.band.size(); ++k) {
      values.push_back(curve.y[k] - curve.band[k]);
      values.push_back(curve.y[k] + curve.band[k]);
    }
  if (!chart.y.logarithmic) add_air(values);
  return values;
}

/// Coordinates of the curves that are drawn with marks, along x, or along y with their error bars.
std::vector<double> marked_values(const Chart& chart, bool along_x) {
  std::vector<double> values;
  for (const auto& curve : chart.curves) {
    if (curve.style != CurveStyle::kMarkers && curve.style != CurveStyle::kLineAndMarkers) continue;
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      if (!std::isfinite(curve.x[k]) || !std::isfinite(curve.y[k])) continue;
      const double value = along_x ? curve.x[k] : curve.y[k];
      values.push_back(value);
      if (along_x || curve.y_error.empty() || !std::isfinite(curve.y_error[k])) continue;
      values.push_back(value - curve.y_error[k]);
      values.push_back(value + curve.y_error[k]);
    }
  }
  return values;
}

/// `range` with a margin beyond what is marked, so that no mark lies on the frame; a limit that was given
/// stays, and so does zero where nothing is beyond it.
Interval with_margin(const Interval& range, const ChartAxis& axis, const std::vector<double>& marked) {
  constexpr double kBeyond = 0.05;  // of the axis
  const auto place = [&](double value) { return axis.logarithmic ? std::log10(value) : value; };
  const auto value = [&](double at) { return axis.logarithmic ? std::pow(10, at) : at; };
  const double margin = kBeyond * (place(range.upper) - place(range.lower));
  Interval wide = range;
  for (const double each : marked) {
    if (axis.logarithmic && each <= 0) continue;
    if (std::isnan(axis.lower) && range.lower != 0)
      wide.lower = std::min(wide.lower, value(place(each) - margin));
    if (std::isnan(axis.upper) && range.upper != 0)
      wide.upper = std::max(wide.upper, value(place(each) + margin));
  }
  if (axis.logarithmic) return wide;
  if (range.lower > 0) wide.lower = std::max(0.0, wide.lower);
  if (range.upper < 0) wide.upper = std::min(0.0, wide.upper);
  return wide;
}

Axis make_axis(const ChartAxis& wanted, const Interval& range, int most_ticks) {
  Axis axis{QString::fromStdString(wanted.label), range, {}, wanted.logarithmic};
  axis.ticks = wanted.logarithmic ? decade_ticks(range)
               : wanted.degrees   ? angle_ticks(range, most_ticks)
                                  : nice_ticks(range, most_ticks);
  return axis;
}

// Limits for values that are all there is: a single value gets room on both sides.
Interval linear_range(double lowest, double highest, bool from_zero) {
  if (from_zero || (lowest > 0 && lowest < 0.35 * highest)) lowest = std::min(lowest, 0.0);
  if (from_zero || (highest < 0 && highest > 0.35 * lowest)) highest = std::max(highest, 0.0);
  const double magnitude = std::max(std::abs(lowest), std::abs(highest));
  if (highest - lowest <= 1e-9 * magnitude || magnitude == 0) {
    const double room = magnitude > 0 ? 0.1 * magnitude : 1.0;
    lowest -= room;
    highest += room;
  }
  return widen_to_nice({lowest, highest}, kYTicks);
}

}  // namespace

Interval axis_range(const ChartAxis& axis, const std::vector<double>& values, bool from_zero) {
  double lowest = INFINITY, highest = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value) || (axis.logarithmic && value <= 0)) continue;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  Interval range = axis.logarithmic ? Interval{1, 10} : Interval{0, 1};
  if (lowest <= highest) {
    range = axis.logarithmic ? Interval{std::pow(10.0, std::floor(std::log10(lowest) + 1e-9)),
                                        std::pow(10.0, std::ceil(std::log10(highest) - 1e-9))}
                             : linear_range(lowest, highest, from_zero);
    if (axis.logarithmic && range.upper <= range.lower) range.upper = 10 * range.lower;
  }
  if (!std::isnan(axis.lower)) range.lower = axis.lower;
  if (!std::isnan(axis.upper)) range.upper = axis.upper;
  if (!std::isfinite(range.length()) || range.lower >= range.upper || (axis.logarithmic && range.lower <= 0))
    throw std::runtime_error("axis '" + axis.label + "': limits " + std::to_string(range.lower) + " to " +
                             std::to_string(range.upper) + " must increase" +
                             (axis.logarithmic ? " and be positive (logarithmic axis)" : ""));
  return range;
}

void check_chart(const Chart& chart) {
  for (const auto& curve : chart.curves) {
    const bool matches = curve.x.size() == curve.y.size() &&
                         (curve.y_error.empty() || curve.y_error.size() == curve.y.size()) &&
                         (curve.band.empty() || curve.band.size() == curve.y.size());
    if (!matches)
      throw std::runtime_error("chart '" + chart.title + "', curve '" + curve.name +
                               "': " + std::to_string(curve.x.size()) + " x, " +
                               std::to_string(curve.y.size()) + " y and " +
                               std::to_string(curve.y_error.size()) + " errors have unequal lengths");
  }
}

namespace {

struct ChartLayout {
  PlotArea plot;
  Heading heading;
  double legend_left = 0, legend_top = 0, legend_width = 0;
  double height = 0;
};

ChartLayout lay_out(const Chart& chart) {
  const bool has_bars = std::any_of(chart.curves.begin(), chart.curves.end(),
                                    [](const Curve& curve) { return curve.style == CurveStyle::kBars; });
  ChartLayout layout{{}, Heading(chart.title, chart.subtitle, kWidth - 2 * kMargin)};
  const Interval x = axis_range(chart.x, x_values(chart), false);
  const Interval y = axis_range(chart.y, y_values(chart), has_bars);
  layout.plot.x = make_axis(chart.x, with_margin(x, chart.x, marked_values(chart, true)), kXTicks);
  layout.plot.y = make_axis(chart.y, with_margin(y, chart.y, marked_values(chart, false)), kYTicks);
  const double left = kMargin + left_margin(layout.plot.y), right = kWidth - kRightMargin;
  layout.legend_left = left;
  layout.legend_width = right - left;
  layout.legend_top = kMargin + layout.heading.height() + 8;
  const double legend = draw_legend(nullptr, chart.curves, left, layout.legend_top, right - left);
  layout.height = kHeight + std::max(0.0, legend - kUsualLegend);
  const double top = layout.legend_top + legend + (chart.markers.empty() ? 12 : kMarkerBand);
  const double bottom = layout.height - kMargin - bottom_margin() - (chart.note.empty() ? 0 : 44);
  layout.plot.rect = QRectF(QPointF(std::round(left), std::round(top)), QPointF(right, std::round(bottom)));
  return layout;
}

void paint_chart(QPainter& painter, const Chart& chart, const ChartLayout& layout) {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  layout.heading.draw(painter, kMargin, kMargin - 8);
  draw_legend(&painter, chart.curves, layout.legend_left, layout.legend_top, layout.legend_width);
  draw_grid(painter, layout.plot);
  painter.save();
  painter.setClipRect(layout.plot.rect.adjusted(-12, -12, 12, 12));
  for (std::size_t k = 0; k < chart.curves.size(); ++k) draw_curve(painter, layout.plot, chart.curves, k);
  painter.restore();
  draw_axes(painter, layout.plot, {kWidth, layout.height});
  std::vector<AxisMarker> markers;
  for (const auto& marker : chart.markers) markers.push_back({marker.x, QString::fromStdString(marker.text)});
  draw_markers(painter, layout.plot, markers);
  draw_centred(painter, {0.5 * kWidth, layout.height - kMargin - 8}, QString::fromStdString(chart.note),
               kNotePixels, kWidth - 2 * kMargin);
}

}  // namespace

ChartPicture compose_chart(const Chart& chart) {
  check_chart(chart);
  const ChartLayout layout = lay_out(chart);
  ChartPicture picture{white_canvas(static_cast<int>(kWidth), static_cast<int>(layout.height), chart.pixels),
                       layout.plot};
  QPainter painter(&picture.image);
  paint_chart(painter, chart, layout);
  return picture;
}

void draw_chart(const std::filesystem::path& png, const Chart& chart) {
  write_png(png, compose_chart(chart).image);
}

void draw_chart_pdf(const std::filesystem::path& pdf, const Chart& chart) {
  check_chart(chart);
  const ChartLayout layout = lay_out(chart);
  write_pdf_page(pdf, {kWidth, layout.height},
                 [&](QPainter& painter) { paint_chart(painter, chart, layout); });
}

}  // namespace diefill::render
