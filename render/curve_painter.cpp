#include "render/curve_painter.h"

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/text.h"

namespace diefill::render {
namespace {

constexpr double kLineWidth = 4;
constexpr double kMarkerRadius = 8;
constexpr double kSampleLength = 64;  // of the piece of curve in the legend
constexpr double kLegendRow = 42;

QPen curve_pen(std::size_t index) {
  static constexpr std::array<Qt::PenStyle, 4> kDashes{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine,
                                                       Qt::DotLine};
  QPen pen(curve_colour(index), kLineWidth, kDashes[index % kDashes.size()]);
  pen.setJoinStyle(Qt::RoundJoin);
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

void draw_marker(QPainter& painter, const QPointF& at, std::size_t index) {
  const double r = kMarkerRadius;
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(curve_colour(index));
  switch (index % 4) {
    case 0:
      painter.drawEllipse(at, r, r);
      break;
    case 1:
      painter.drawRect(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r));
      break;
    case 2:
      painter.drawPolygon(
          QPolygonF({at + QPointF(0, -1.3 * r), at + QPointF(1.2 * r, r), at + QPointF(-1.2 * r, r)}));
      break;
    default:
      painter.drawPolygon(QPolygonF({at + QPointF(0, -1.4 * r), at + QPointF(1.4 * r, 0),
                                     at + QPointF(0, 1.4 * r), at + QPointF(-1.4 * r, 0)}));
  }
}

bool is_drawable(const QPointF& point) {
  return std::isfinite(point.x()) && std::isfinite(point.y());
}

void draw_line(QPainter& painter, const PlotArea& area, const Curve& curve, std::size_t index) {
  QPainterPath path;
  bool in_piece = false;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const QPointF point = area.pixel(curve.x[k], curve.y[k]);
    if (!is_drawable(point)) {
      in_piece = false;
      continue;
    }
    if (in_piece)
      path.lineTo(point);
    else
      path.moveTo(point);
    in_piece = true;
  }
  painter.setPen(curve_pen(index));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
}

void draw_error_bars(QPainter& painter, const PlotArea& area, const Curve& curve, std::size_t index) {
  constexpr double kCap = 7;
  painter.setPen(QPen(curve_colour(index), 2.5));
  for (std::size_t k = 0; k < curve.y_error.size(); ++k) {
    const QPointF top = area.pixel(curve.x[k], curve.y[k] + curve.y_error[k]);
    QPointF foot = area.pixel(curve.x[k], curve.y[k] - curve.y_error[k]);
    if (!is_drawable(top)) continue;
    if (!is_drawable(foot)) foot = {top.x(), area.rect.bottom()};  // beyond a logarithmic axis
    painter.drawLine(top, foot);
    painter.drawLine(top + QPointF(-kCap, 0), top + QPointF(kCap, 0));
    painter.drawLine(foot + QPointF(-kCap, 0), foot + QPointF(kCap, 0));
  }
}

void draw_bars(QPainter& painter, const PlotArea& area, const Curve& curve, std::size_t index) {
  QColor fill = curve_colour(index);
  fill.setAlpha(150);
  painter.setBrush(fill);
  painter.setPen(QPen(curve_colour(index), 2));
  const std::size_t count = curve.x.size();
  for (std::size_t k = 0; k < count; ++k) {
    const double spacing = count < 2       ? 1
                           : k + 1 < count ? curve.x[k + 1] - curve.x[k]
                                           : curve.x[k] - curve.x[k - 1];
    const QPointF top_left = area.pixel(curve.x[k] - 0.5 * spacing, curve.y[k]);
    const QPointF base =
        area.pixel(curve.x[k] + 0.5 * spacing, area.y.logarithmic ? area.y.range.lower : 0.0);
    if (is_drawable(top_left) && is_drawable(base)) painter.drawRect(QRectF(top_left, base).normalized());
  }
}

void draw_sample(QPainter& painter, const Curve& curve, std::size_t index, double left, double middle) {
  if (curve.style == CurveStyle::kBars) {
    QColor fill = curve_colour(index);
    fill.setAlpha(150);
    painter.setBrush(fill);
    painter.setPen(QPen(curve_colour(index), 2));
    painter.drawRect(QRectF(left + 16, middle - 12, 32, 24));
    return;
  }
  if (curve.style != CurveStyle::kMarkers) {
    painter.setPen(curve_pen(index));
    painter.drawLine(QPointF(left, middle), QPointF(left + kSampleLength, middle));
  }
  if (curve.style != CurveStyle::kLine) draw_marker(painter, {left + 0.5 * kSampleLength, middle}, index);
}

}  // namespace

QColor curve_colour(std::size_t index) {
  static const std::array<QColor, 8> kColours{
      QColor(0, 114, 178), QColor(213, 94, 0),   QColor(0, 158, 115), QColor(204, 121, 167),
      QColor(0, 0, 0),     QColor(86, 180, 233), QColor(230, 159, 0), QColor(130, 130, 130)};
  return kColours[index % kColours.size()];
}

void draw_curve(QPainter& painter, const PlotArea& area, const Curve& curve, std::size_t index) {
  if (curve.style == CurveStyle::kBars) {
    draw_bars(painter, area, curve, index);
  } else if (curve.style != CurveStyle::kMarkers) {
    draw_line(painter, area, curve, index);
  }
  draw_error_bars(painter, area, curve, index);
  if (curve.style != CurveStyle::kMarkers && curve.style != CurveStyle::kLineAndMarkers) return;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const QPointF point = area.pixel(curve.x[k], curve.y[k]);
    if (is_drawable(point)) draw_marker(painter, point, index);
  }
}

double draw_legend(QPainter* painter, const std::vector<Curve>& curves, double left, double top,
                   double width) {
  const QFont font = text_font(kTickPixels);
  double x = left, y = top;
  bool any = false;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (curves[k].name.empty()) continue;
    const double room = width - kSampleLength - 12;
    const QString name =
        QFontMetricsF(font).elidedText(QString::fromStdString(curves[k].name), Qt::ElideRight, room);
    const double length = kSampleLength + 12 + text_width(name, font);
    if (x > left && x + length > left + width) {
      x = left;
      y += kLegendRow;
    }
    if (painter) {
      draw_sample(*painter, curves[k], k, x, y + 0.5 * kLegendRow);
      painter->setFont(font);
      painter->setPen(Qt::black);
      painter->drawText(QRectF(x + kSampleLength + 12, y, text_width(name, font) + 4, kLegendRow),
                        Qt::AlignLeft | Qt::AlignVCenter, name);
    }
    x += length + 40;
    any = true;
  }
  return any ? y + kLegendRow - top : 0;
}

}  // namespace diefill::render
