#include "render/style/axes.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kTickLength = 10;
constexpr double kMinorTickLength = 5;
constexpr double kTickGap = 8;
constexpr double kLineHeight = 1.25;
const QColor kGridColour(225, 225, 225);

double widest_label(const Axis& axis) {
  double widest = 0;
  for (const auto& label : axis.ticks.labels)
    widest = std::max(widest, text_width(QString::fromStdString(label), text_font(kTickPixels)));
  return widest;
}

void draw_x_ticks(QPainter& painter, const PlotArea& area) {
  const QRectF& rect = area.rect;
  const TickTexts texts = x_tick_texts(area);
  painter.setFont(text_font(texts.pixels));
  for (std::size_t k = 0; k < area.x.ticks.at.size(); ++k) {
    const double x = area.pixel(area.x.ticks.at[k], 0).x();
    const QString& label = texts.labels[k];
    const double length = label.isEmpty() ? kMinorTickLength : kTickLength;
    painter.drawLine(QPointF(x, rect.bottom()), QPointF(x, rect.bottom() + length));
    painter.drawText(QRectF(x - 200, rect.bottom() + kTickLength + kTickGap, 400, kLineHeight * kTickPixels),
                     Qt::AlignHCenter | Qt::AlignTop, label);
  }
}

void draw_y_ticks(QPainter& painter, const PlotArea& area) {
  const QRectF& rect = area.rect;
  for (std::size_t k = 0; k < area.y.ticks.at.size(); ++k) {
    const double y = area.pixel(0, area.y.ticks.at[k]).y();
    const QString label = QString::fromStdString(area.y.ticks.labels[k]);
    const double length = label.isEmpty() ? kMinorTickLength : kTickLength;
    painter.drawLine(QPointF(rect.left() - length, y), QPointF(rect.left(), y));
    painter.drawText(QRectF(rect.left() - kTickLength - kTickGap - 400, y - 30, 400, 60),
                     Qt::AlignRight | Qt::AlignVCenter, label);
  }
}

// Centre of a label of some length that stays `margin` inside 0..extent.
double keep_inside(double centre, double length, double extent) {
  constexpr double kMargin = 12;
  const double half = 0.5 * length + kMargin;
  return half >= extent - half ? 0.5 * extent : std::clamp(centre, half, extent - half);
}

}  // namespace

double Axis::fraction(double value) const {
  if (!logarithmic) return (value - range.lower) / range.length();
  if (!(value > 0)) return std::nan("");
  return std::log(value / range.lower) / std::log(range.upper / range.lower);
}

QPointF PlotArea::pixel(double x_value, double y_value) const {
  return {rect.left() + x.fraction(x_value) * rect.width(),
          rect.bottom() - y.fraction(y_value) * rect.height()};
}

QPointF PlotArea::value(const QPointF& pixel) const {
  return {x.range.lower + (pixel.x() - rect.left()) / rect.width() * x.range.length(),
          y.range.lower + (rect.bottom() - pixel.y()) / rect.height() * y.range.length()};
}

TickTexts x_tick_texts(const PlotArea& area) {
  constexpr double kApart = 14;  // pixels
  TickTexts texts;
  double room = 2 * area.rect.width(), before = std::nan("");
  for (std::size_t k = 0; k < area.x.ticks.at.size(); ++k) {
    texts.labels.push_back(QString::fromStdString(area.x.ticks.labels[k]));
    if (texts.labels.back().isEmpty()) continue;
    const double x = area.pixel(area.x.ticks.at[k], 0).x();
    if (std::isfinite(before)) room = std::min(room, x - before - kApart);
    before = x;
  }
  for (const QString& label : texts.labels)
    texts.pixels = std::min(texts.pixels, fitting_pixels(label, kTickPixels, room));
  const QFontMetricsF metrics(text_font(texts.pixels));
  for (QString& label : texts.labels) label = metrics.elidedText(label, Qt::ElideMiddle, room + 1);
  return texts;
}

double left_margin(const Axis& y) {
  return kTickLength + kTickGap + widest_label(y) + 18 + kLineHeight * kLabelPixels;
}

double bottom_margin() {
  return kTickLength + kTickGap + kLineHeight * kTickPixels + 10 + kLineHeight * kLabelPixels;
}

void draw_grid(QPainter& painter, const PlotArea& area) {
  painter.setPen(QPen(kGridColour, 1.5));
  for (std::size_t k = 0; k < area.x.ticks.at.size(); ++k) {
    if (area.x.ticks.labels[k].empty()) continue;
    const double x = area.pixel(area.x.ticks.at[k], 0).x();
    painter.drawLine(QPointF(x, area.rect.top()), QPointF(x, area.rect.bottom()));
  }
  for (std::size_t k = 0; k < area.y.ticks.at.size(); ++k) {
    if (area.y.ticks.labels[k].empty()) continue;
    const double y = area.pixel(0, area.y.ticks.at[k]).y();
    painter.drawLine(QPointF(area.rect.left(), y), QPointF(area.rect.right(), y));
  }
}

void draw_axes(QPainter& painter, const PlotArea& area, const QSizeF& canvas) {
  painter.setPen(QPen(Qt::black, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area.rect);
  draw_x_ticks(painter, area);
  painter.setFont(text_font(kTickPixels));
  draw_y_ticks(painter, area);

  const QFont font = text_font(kLabelPixels);
  const double x_length = std::min(text_width(area.x.label, font), canvas.width() - 24);
  const double below = area.rect.bottom() + bottom_margin() - 0.5 * kLineHeight * kLabelPixels;
  draw_centred(painter, {keep_inside(area.rect.center().x(), x_length, canvas.width()), below}, area.x.label,
               kLabelPixels, x_length);
  const double y_length = std::min(text_width(area.y.label, font), canvas.height() - 24);
  const double beside = area.rect.left() - left_margin(area.y) + 0.5 * kLineHeight * kLabelPixels;
  draw_centred(painter, {beside, keep_inside(area.rect.center().y(), y_length, canvas.height())},
               area.y.label, kLabelPixels, y_length, -90);
}

void draw_markers(QPainter& painter, const PlotArea& area, const std::vector<AxisMarker>& markers) {
  constexpr double kArrow = 9;
  const QFont font = text_font(kNotePixels);
  for (const auto& marker : markers) {
    const double x = area.pixel(marker.x, 0).x();
    const double tip = area.rect.top() - 2;
    QPainterPath arrow(QPointF(x, tip));
    arrow.lineTo(x - kArrow, tip - 1.5 * kArrow);
    arrow.lineTo(x + kArrow, tip - 1.5 * kArrow);
    arrow.closeSubpath();
    painter.fillPath(arrow, Qt::black);
    const double width = text_width(marker.text, font);
    double left = x - 0.5 * width;
    left = std::clamp(left, area.rect.left() - kArrow,
                      std::max(area.rect.left(), area.rect.right() + kArrow - width));
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(QRectF(left, tip - 1.5 * kArrow - 34, width + 2, 30), Qt::AlignLeft | Qt::AlignBottom,
                     marker.text);
  }
}

std::vector<AxisMarker> shoe_markers() {
  return {{0, QStringLiteral("shoe arrives")},
          {180, QStringLiteral("shoe leaves")},
          {360, QStringLiteral("shoe arrives")}};
}

}  // namespace diefill::render
