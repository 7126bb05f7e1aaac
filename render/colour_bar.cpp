#include "render/colour_bar.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/colour_map.h"
#include "render/text.h"

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
                   paint_colour(map_colour(1)));
  painter.fillRect(QRectF(rect.left(), rect.bottom(), rect.width(), kBarPoint), paint_colour(map_colour(0)));
  painter.setRenderHint(QPainter::Antialiasing, false);
  const int rows = static_cast<int>(std::lround(rect.height()));
  for (int row = 0; row < rows; ++row) {
    const double fraction = 1 - (row + 0.5) / rows;
    painter.fillRect(QRectF(rect.left(), rect.top() + row, rect.width(), 1),
                     paint_colour(map_colour(fraction)));
  }
  painter.restore();
}

}  // namespace

ColourBar make_colour_bar(const QString& label, std::span<const double> values, const Interval& wanted) {
  const Interval automatic = robust_range(values);
  ColourBar bar{label, wanted, false, false};
  if (std::isnan(wanted.lower)) bar.range.lower = automatic.lower;
  if (std::isnan(wanted.upper)) bar.range.upper = automatic.upper;
  if (!(bar.range.lower < bar.range.upper) || !std::isfinite(bar.range.length()))
    throw std::runtime_error("colour range: the lower limit " + std::to_string(bar.range.lower) +
                             " must be below the upper limit " + std::to_string(bar.range.upper));
  for (const double value : values) {
    bar.open_below |= value < bar.range.lower;
    bar.open_above |= value > bar.range.upper;
  }
  return bar;
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
