#include "render/style/colour_bar.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "process/results/formatted.h"
#include "render/style/colour_map.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kTickLength = 9;
constexpr double kTickGap = 8;
constexpr double kLabelGap = 16;

QColor paint_colour(const Rgb& colour) {
  return {colour.red, colour.green, colour.blue};
}

Ticks bar_ticks(const ColourBar& bar) {
  return nice_ticks(bar.range, 7);
}

double widest_label(const Ticks& ticks) {
  double widest = 0;
  for (const auto& label : ticks.labels)
    widest = std::max(widest, text_width(QString::fromStdString(label), text_font(kTickPixels)));
  return widest;
}

// Outline of the bar including its pointed ends.
QPainterPath outline(const ColourBar& bar, const QRectF& rect) {
  QPainterPath path(rect.topLeft());
  if (bar.open_above) path.lineTo(rect.center().x(), rect.top() - kBarPoint);
  path.lineTo(rect.topRight());
  path.lineTo(rect.bottomRight());
  if (bar.open_below) path.lineTo(rect.center().x(), rect.bottom() + kBarPoint);
  path.lineTo(rect.bottomLeft());
  path.closeSubpath();
  return path;
}

void fill_bar(QPainter& painter, const ColourBar& bar, const QRectF& rect) {
  painter.save();
  painter.setClipPath(outline(bar, rect));
  painter.fillRect(QRectF(rect.left(), rect.top() - kBarPoint, rect.width(), kBarPoint),
                   paint_colour(scale_colour(bar.colours, 1)));
  painter.fillRect(QRectF(rect.left(), rect.bottom(), rect.width(), kBarPoint),
                   paint_colour(scale_colour(bar.colours, 0)));
  painter.setRenderHint(QPainter::Antialiasing, false);
  const int rows = static_cast<int>(std::lround(rect.height()));
  for (int row = 0; row < rows; ++row) {
    const double fraction = 1 - (row + 0.5) / rows;
    painter.fillRect(QRectF(rect.left(), rect.top() + row, rect.width(), 1),
                     paint_colour(scale_colour(bar.colours, fraction)));
  }
  painter.restore();
}

void draw_mark(QPainter& painter, const ColourBar& bar, const QRectF& rect) {
  constexpr double kSize = 11;
  const double y = rect.bottom() - (bar.mark - bar.range.lower) / bar.range.length() * rect.height();
  QPainterPath arrow(QPointF(rect.left() - 1, y));
  arrow.lineTo(rect.left() - 1 - 1.6 * kSize, y - kSize);
  arrow.lineTo(rect.left() - 1 - 1.6 * kSize, y + kSize);
  arrow.closeSubpath();
  painter.fillPath(arrow, Qt::black);
}

}  // namespace

ColourBar make_colour_bar(const QString& label, std::span<const double> values, const Interval& wanted) {
  const Interval automatic = robust_range(values);
  ColourBar bar;
  bar.label = label;
  bar.range = wanted;
  if (std::isnan(wanted.lower)) bar.range.lower = automatic.lower;
  if (std::isnan(wanted.upper)) bar.range.upper = automatic.upper;
  if (!(bar.range.lower < bar.range.upper) || !std::isfinite(bar.range.length()))
    throw std::runtime_error(results::formatted("colour range: the lower limit %g", bar.range.lower) +
                             results::formatted(" must be below the upper limit %g", bar.range.upper));
  for (const double value : values) {
    bar.open_below |= value < bar.range.lower;
    bar.open_above |= value > bar.range.upper;
  }
  return bar;
}

ColourBar make_diverging_bar(const QString& label, std::span<const double> values, double wanted) {
  double limit = wanted;
  if (std::isnan(wanted)) {
    std::vector<double> sizes;
    for (const double value : values)
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
    std::sort(sizes.begin(), sizes.end());
    const double most = sizes.empty() ? 0 : sizes[sizes.size() * 9 / 10];
    limit = most > 0 ? widen_to_nice({0, most}, 4).upper : 1;
  }
  ColourBar bar = make_colour_bar(label, values, {-limit, limit});
  bar.colours = ColourScale::kDiverging;
  return bar;
}

Rgb bar_colour(const ColourBar& bar, double value) {
  return scale_colour(bar.colours, (value - bar.range.lower) / bar.range.length());
}

double colour_bar_width(const ColourBar& bar) {
  return kBarWidth + kTickLength + kTickGap + widest_label(bar_ticks(bar)) + kLabelGap + 1.25 * kLabelPixels;
}

void draw_colour_bar(QPainter& painter, const ColourBar& bar, const QRectF& bar_rect) {
  fill_bar(painter, bar, bar_rect);
  painter.setPen(QPen(Qt::black, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline(bar, bar_rect));
  painter.setFont(text_font(kTickPixels));
  const Ticks ticks = bar_ticks(bar);
  for (std::size_t k = 0; k < ticks.at.size(); ++k) {
    const double y =
        bar_rect.bottom() - (ticks.at[k] - bar.range.lower) / bar.range.length() * bar_rect.height();
    painter.drawLine(QPointF(bar_rect.right(), y), QPointF(bar_rect.right() + kTickLength, y));
    painter.drawText(QRectF(bar_rect.right() + kTickLength + kTickGap, y - 30, 300, 60),
                     Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(ticks.labels[k]));
  }
  if (bar.mark >= bar.range.lower && bar.mark <= bar.range.upper) draw_mark(painter, bar, bar_rect);
  const double label_x = bar_rect.left() + colour_bar_width(bar) - 0.625 * kLabelPixels;
  draw_centred(painter, {label_x, bar_rect.center().y()}, bar.label, kLabelPixels,
               bar_rect.height() + 2 * kBarPoint, -90);
}

double draw_swatch(QPainter& painter, const QPointF& corner, const QColor& colour, const QString& text) {
  constexpr double kSide = 28;
  painter.setPen(QPen(Qt::black, 1.5));
  painter.setBrush(colour);
  painter.drawRect(QRectF(corner, QSizeF(kSide, kSide)));
  const QFont font = text_font(kNotePixels);
  const double width = text_width(text, font);
  painter.setFont(font);
  painter.setPen(Qt::black);
  painter.drawText(QRectF(corner.x() + kSide + 10, corner.y() - 8, width + 4, kSide + 16),
                   Qt::AlignLeft | Qt::AlignVCenter, text);
  return kSide + 10 + width;
}

}  // namespace diefill::render
