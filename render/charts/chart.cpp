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

/// What is drawn along one axis.
struct Coordinates {
  std::vector<double> lines;  ///< also bars and bands
  std::vector<double> marks;  ///< with their error bars
};

Coordinates coordinates_along_x(const Chart& chart) {
  Coordinates drawn;
  for (const auto& curve : chart.curves) {
    const auto& x = curve.x;
    for (std::size_t k = 0; k < x.size(); ++k)
      (has_marks(curve.style) && std::isfinite(curve.y[k]) ? drawn.marks : drawn.lines).push_back(x[k]);
    if (curve.style != CurveStyle::kBars || x.size() < 2) continue;
    drawn.lines.push_back(x.front() - 0.5 * (x[1] - x[0]));
    drawn.lines.push_back(x.back() + 0.5 * (x.back() - x[x.size() - 2]));
  }
  return drawn;
}

Coordinates coordinates_along_y(const Chart& chart) {
  Coordinates drawn;
  const auto add = [](std::vector<double>& values, const Curve& curve, const std::vector<double>& half) {
    for (std::size_t k = 0; k < half.size(); ++k)
      values.insert(values.end(), {curve.y[k] - half[k], curve.y[k] + half[k]});
  };
  for (const auto& curve : chart.curves) {
    auto& own = has_marks(curve.style) ? drawn.marks : drawn.lines;
    own.insert(own.end(), curve.y.begin(), curve.y.end());
    add(own, curve, curve.y_error);
    add(drawn.lines, curve, curve.band);
  }
  return drawn;
}

/// From the least to the greatest of the values that an axis can show; the other way round where there is
/// none.
Interval extent_of(const std::vector<double>& values, bool logarithmic) {
  Interval extent{INFINITY, -INFINITY};
  for (const double value : values) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) continue;
    extent.lower = std::min(extent.lower, value);
    extent.upper = std::max(extent.upper, value);
  }
  return extent;
}

/// `range` with a share of itself free beyond what it is to hold. Zero stays a limit where nothing lies
/// beyond it: a mass or a count does not go below it.
Interval widened(const Interval& range, const Interval& held, double share, bool logarithmic) {
  const auto place = [&](double value) { return logarithmic ? std::log10(value) : value; };
  const auto value = [&](double at) { return logarithmic ? std::pow(10, at) : at; };
  const double room = share * (place(range.upper) - place(range.lower));
  Interval wide = range;
  if (held.lower > held.upper) return wide;
  if (range.lower != 0) wide.lower = std::min(wide.lower, value(place(held.lower) - room));
  if (range.upper != 0) wide.upper = std::max(wide.upper, value(place(held.upper) + room));
  if (logarithmic) return wide;
  if (range.lower > 0) wide.lower = std::max(0.0, wide.lower);
  if (range.upper < 0) wide.upper = std::min(0.0, wide.upper);
  return wide;
}

/// The range of an axis over what is drawn along it. Marks keep a twentieth of the axis free, so that none
/// lies on the frame. `beyond_lines`: of what all span, free beyond lines where the round number at the end
/// of the axis is chosen. Limits that are given stay.
Interval range_over(const ChartAxis& axis, const Coordinates& drawn, double beyond_lines, bool from_zero) {
  constexpr double kBeyondMarks = 0.05;
  const Interval lines = extent_of(drawn.lines, axis.logarithmic),
                 marks = extent_of(drawn.marks, axis.logarithmic),
                 all{std::min(lines.lower, marks.lower), std::max(lines.upper, marks.upper)},
                 wide_lines = widened(all, lines, beyond_lines, axis.logarithmic);
  const Interval rounded =
      axis_range(axis, {wide_lines.lower, wide_lines.upper, marks.lower, marks.upper}, from_zero);
  const Interval range = widened(rounded, marks, kBeyondMarks, axis.logarithmic);
  return {std::isnan(axis.lower) ? range.lower : axis.lower,
          std::isnan(axis.upper) ? range.upper : axis.upper};
}

Axis make_axis(const ChartAxis& wanted, const Interval& range, int most_ticks) {
  Axis axis{QString::fromStdString(wanted.label), range, {}, wanted.logarithmic};
  axis.label.replace(QStringLiteral("[deg]"), QStringLiteral("[°]"));
  axis.ticks = wanted.logarithmic    ? decade_ticks(range)
               : wanted.in_degrees() ? angle_ticks(range, most_ticks)
                                     : nice_ticks(range, most_ticks);
  return axis;
}

// Limits for values that are all there is: a single value gets room on both sides.
Interval linear_range(double lowest, double highest, bool from_zero, bool degrees) {
  if (from_zero || (lowest > 0 && lowest < 0.35 * highest)) lowest = std::min(lowest, 0.0);
  if (from_zero || (highest < 0 && highest > 0.35 * lowest)) highest = std::max(highest, 0.0);
  const double magnitude = std::max(std::abs(lowest), std::abs(highest));
  if (highest - lowest <= 1e-9 * magnitude || magnitude == 0) {
    const double room = magnitude > 0 ? 0.1 * magnitude : 1.0;
    lowest -= room;
    highest += room;
  }
  return degrees ? widen_to_angles({lowest, highest}, kYTicks) : widen_to_nice({lowest, highest}, kYTicks);
}

}  // namespace

bool ChartAxis::in_degrees() const {
  return label.ends_with("[°]") || label.ends_with("[deg]");
}

Interval axis_range(const ChartAxis& axis, const std::vector<double>& values, bool from_zero) {
  const auto [lowest, highest] = extent_of(values, axis.logarithmic);
  Interval range = axis.logarithmic ? Interval{1, 10} : Interval{0, 1};
  if (lowest <= highest) {
    range = axis.logarithmic ? Interval{std::pow(10.0, std::floor(std::log10(lowest) + 1e-9)),
                                        std::pow(10.0, std::ceil(std::log10(highest) - 1e-9))}
                             : linear_range(lowest, highest, from_zero, axis.in_degrees());
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
  constexpr double kBeyondLines = 0.02;  // a curve shall not run along the frame
  const Interval x = range_over(chart.x, coordinates_along_x(chart), 0, false);
  const Interval y =
      range_over(chart.y, coordinates_along_y(chart), chart.y.logarithmic ? 0 : kBeyondLines, has_bars);
  layout.plot.x = make_axis(chart.x, x, kXTicks);
  layout.plot.y = make_axis(chart.y, y, kYTicks);
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

bool has_points(const Chart& chart) {
  return std::ranges::any_of(chart.curves, [](const Curve& curve) {
    return std::ranges::any_of(curve.y, [](double value) { return std::isfinite(value); });
  });
}

void paint_chart(QPainter& painter, const Chart& chart, const ChartLayout& layout) {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  layout.heading.draw(painter, kMargin, kMargin - 8);
  draw_legend(&painter, chart.curves, layout.legend_left, layout.legend_top, layout.legend_width);
  draw_grid(painter, layout.plot);
  for (std::size_t k = 0; k < chart.curves.size(); ++k) draw_curve(painter, layout.plot, chart.curves, k);
  draw_axes(painter, layout.plot, {kWidth, layout.height});
  if (!has_points(chart))
    draw_centred(painter, layout.plot.rect.center(), QStringLiteral("no values"), kLabelPixels,
                 layout.plot.rect.width());
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
