#include <algorithm>
#include <cmath>

#include "render/charts/curve_painter.h"
#include "render/charts/tradeoff_chart.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

using results::ParameterRow;
using results::Tradeoff;
using results::TradeoffPoint;

constexpr double kWidth = 1600, kMargin = 36, kRightMargin = 64;
constexpr double kDeviationHeight = 520, kCostHeight = 230, kGap = 34;

/// Signed deviations from the base, percent of each quantity's scale, a curve for every deciding quantity.
std::vector<Curve> deviations(const Tradeoff& tradeoff, const ParameterRow& parameter) {
  std::vector<Curve> curves;
  const TradeoffPoint& base = tradeoff.points.front();
  for (std::size_t q = 0; q < tradeoff.quantities.size(); ++q) {
    const auto& quantity = tradeoff.quantities[q];
    if (!quantity.decides || !std::isfinite(base.values[q].mean)) continue;
    double scale = std::abs(base.values[q].mean);
    for (std::size_t s = 0; s < tradeoff.quantities.size(); ++s)
      if (tradeoff.quantities[s].key == quantity.scale) scale = std::abs(base.values[s].mean);
    Curve curve{quantity.name, {}, {}, CurveStyle::kLineAndMarkers, {}};
    for (std::size_t k = 0; k < parameter.points.size(); ++k) {
      const auto& value = tradeoff.points[parameter.points[k]].values[q];
      // Side by side, so that error bars do not cover one another.
      curve.x.push_back(static_cast<double>(k) + 0.03 * static_cast<double>(curves.size()));
      curve.y.push_back(100 * (value.mean - base.values[q].mean) / scale);
      curve.y_error.push_back(100 * value.scatter / scale);  // NaN, no bar, where it is not known
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Axis value_axis(const ParameterRow& parameter, bool labelled) {
  Axis axis;
  axis.range = {-0.5, static_cast<double>(parameter.values.size()) - 0.5};
  for (std::size_t k = 0; k < parameter.values.size(); ++k) {
    axis.ticks.at.push_back(static_cast<double>(k));
    axis.ticks.labels.push_back(labelled ? parameter.values[k] + (parameter.points[k] == 0 ? " (base)" : "")
                                         : "");
  }
  if (labelled) axis.label = QString::fromStdString(parameter.label);
  return axis;
}

/// `range` widened to nice numbers, with zero in it.
Axis number_axis(const QString& label, Interval range, int ticks) {
  range = {std::min(range.lower, 0.0), std::max(range.upper, 0.0)};
  if (!(range.length() > 0)) range = {-1, 1};
  const double air = 0.05 * range.length();
  range = widen_to_nice({range.lower < 0 ? range.lower - air : 0, range.upper > 0 ? range.upper + air : 0},
                        ticks);
  return {label, range, nice_ticks(range, ticks), false};
}

Axis deviation_axis(const std::vector<Curve>& curves) {
  Interval range{0, 0};
  for (const Curve& curve : curves)
    for (std::size_t k = 0; k < curve.y.size(); ++k) {
      if (!std::isfinite(curve.y[k])) continue;
      const double error = std::isfinite(curve.y_error[k]) ? curve.y_error[k] : 0;
      range.lower = std::min(range.lower, curve.y[k] - error);
      range.upper = std::max(range.upper, curve.y[k] + error);
    }
  return number_axis(QStringLiteral("Deviation from base [%]"), range, 8);
}

std::vector<Curve> costs(const Tradeoff& tradeoff, const ParameterRow& parameter) {
  Curve curve{"", {}, {}, CurveStyle::kBars, {}};
  for (std::size_t k = 0; k < parameter.points.size(); ++k) {
    curve.x.push_back(static_cast<double>(k));
    curve.y.push_back(tradeoff.points[parameter.points[k]].core_seconds);
  }
  return {curve};
}

void draw_cost_labels(QPainter& painter, const PlotArea& plot, const Curve& curve) {
  for (std::size_t k = 0; k < curve.y.size(); ++k) {
    const bool missing = !std::isfinite(curve.y[k]);
    const QString text = missing ? QStringLiteral("no result") : QString::number(curve.y[k], 'g', 3);
    const QPointF top = plot.pixel(curve.x[k], missing ? 0 : curve.y[k]);
    draw_centred(painter, {top.x(), std::max(top.y() - 20, plot.rect.top() + 20)}, text, kNotePixels, 200);
  }
}

}  // namespace

ParameterPicture compose_parameter(const Tradeoff& tradeoff, const ParameterRow& parameter) {
  const auto curves = deviations(tradeoff, parameter), cost = costs(tradeoff, parameter);
  const Heading heading(tradeoff.title,
                        "Effect of the parameter \"" + parameter.name + "\" alone; bars: scatter over seeds",
                        kWidth - 2 * kMargin);
  ParameterPicture picture;
  picture.deviation.x = value_axis(parameter, false);
  picture.deviation.y = deviation_axis(curves);
  picture.cost.x = value_axis(parameter, true);
  const double most = *std::max_element(cost[0].y.begin(), cost[0].y.end(),
                                        [](double a, double b) { return std::isnan(a) || a < b; });
  picture.cost.y = number_axis(QStringLiteral("Core s"), {0, std::isfinite(most) ? 1.15 * most : 1}, 4);
  const double left =
      std::round(kMargin + std::max(left_margin(picture.deviation.y), left_margin(picture.cost.y)));
  const double right = kWidth - kRightMargin, legend_top = kMargin + heading.height() + 8;
  const double legend = draw_legend(nullptr, curves, left, legend_top, right - left);
  const double top = std::round(legend_top + legend + 12);
  picture.deviation.rect = QRectF(left, top, right - left, kDeviationHeight);
  picture.cost.rect = QRectF(left, top + kDeviationHeight + kGap, right - left, kCostHeight);
  const double height = picture.cost.rect.bottom() + bottom_margin() + kMargin;

  picture.image = white_canvas(static_cast<int>(kWidth), static_cast<int>(height));
  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  heading.draw(painter, kMargin, kMargin - 8);
  draw_legend(&painter, curves, left, legend_top, right - left);
  for (const PlotArea* plot : {&picture.deviation, &picture.cost}) draw_grid(painter, *plot);
  for (std::size_t k = 0; k < curves.size(); ++k) draw_curve(painter, picture.deviation, curves, k);
  draw_curve(painter, picture.cost, cost, 0);
  draw_cost_labels(painter, picture.cost, cost[0]);
  for (const PlotArea* plot : {&picture.deviation, &picture.cost})
    draw_axes(painter, *plot, {kWidth, height});
  return picture;
}

void draw_parameter(const std::filesystem::path& png, const Tradeoff& tradeoff,
                    const ParameterRow& parameter) {
  write_png(png, compose_parameter(tradeoff, parameter).image);
}

}  // namespace diefill::render
