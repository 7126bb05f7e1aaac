#include "render/charts/curve_painter.h"

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "render/charts/legend_layout.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kLineWidth = 4;
constexpr double kMarkerRadius = 8;

// How a curve looks: colours go through all curves; dashes only through those with lines, so that a model's
// line among measured points is solid; with five marker shapes to eight colours no look repeats within forty
// curves. References are grey, thinner, never solid, and take no look from the data.
struct Look {
  QColor colour;
  Qt::PenStyle dash;
  std::size_t shape;
  double width = kLineWidth;
};

Look reference_look(std::size_t references_before) {
  static constexpr std::array<Qt::PenStyle, 3> kDashes{Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  constexpr int kGrey = 90;
  return {QColor(kGrey, kGrey, kGrey), kDashes[references_before % kDashes.size()], 0, 0.75 * kLineWidth};
}

/// A line without a name goes with the curve before it, whose colour it has.
bool is_companion(const std::vector<Curve>& curves, std::size_t index) {
  return index > 0 && curves[index].name.empty() && curves[index].style == CurveStyle::kLine;
}

Look look_of(const std::vector<Curve>& curves, std::size_t index) {
  static constexpr std::array<Qt::PenStyle, 4> kDashes{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine,
                                                       Qt::DotLine};
  std::size_t lines_before = 0, references_before = 0, companions = is_companion(curves, index) ? 1 : 0;
  for (std::size_t k = 0; k < index; ++k) {
    companions += is_companion(curves, k);
    lines_before += curves[k].style == CurveStyle::kLine || curves[k].style == CurveStyle::kLineAndMarkers;
    references_before += curves[k].style == CurveStyle::kReference;
  }
  if (curves[index].style == CurveStyle::kReference) return reference_look(references_before);
  const std::size_t place = index - references_before - companions;
  return {curve_colour(place), kDashes[(lines_before + lines_before / 8) % kDashes.size()], place % 5};
}

QPen curve_pen(const Look& look) {
  QPen pen(look.colour, look.width, look.dash);
  pen.setJoinStyle(Qt::RoundJoin);
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

QPolygonF marker_outline(std::size_t shape) {
  constexpr double r = kMarkerRadius;
  switch (shape) {
    case 1:
      return QRectF(-r, -r, 2 * r, 2 * r);
    case 2:
      return QPolygonF({{0, -1.3 * r}, {1.2 * r, r}, {-1.2 * r, r}});
    case 3:
      return QPolygonF({{0, -1.4 * r}, {1.4 * r, 0}, {0, 1.4 * r}, {-1.4 * r, 0}});
    default:
      return QPolygonF({{0, 1.3 * r}, {1.2 * r, -r}, {-1.2 * r, -r}});
  }
}

void draw_marker(QPainter& painter, const QPointF& at, const Look& look) {
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(look.colour);
  if (look.shape == 0) {
    painter.drawEllipse(at, kMarkerRadius, kMarkerRadius);
  } else {
    painter.drawPolygon(marker_outline(look.shape).translated(at));
  }
}

// A short level piece of a reference's line, which also shows points that no line joins; white keeps it apart
// from the marks that it lies on.
void draw_level_dash(QPainter& painter, const QPointF& at, const Look& look) {
  constexpr double kHalfLength = 20;
  const QPointF half(kHalfLength, 0);
  painter.setPen(QPen(Qt::white, 2.5 * look.width, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(at - half, at + half);
  painter.setPen(curve_pen(look));
  painter.drawLine(at - half, at + half);
}

bool is_drawable(const QPointF& point) {
  return std::isfinite(point.x()) && std::isfinite(point.y());
}

// What lies beyond the axes' limits is not drawn; a curve along the frame keeps its whole width.
void clip_to_frame(QPainter& painter, const PlotArea& area) {
  constexpr double kHalfLine = 0.5 * kLineWidth;
  painter.setClipRect(area.rect.adjusted(-kHalfLine, -kHalfLine, kHalfLine, kHalfLine));
}

void draw_level_dashes(QPainter& painter, const PlotArea& area, const Curve& curve, const Look& look) {
  if (curve.x.size() == 2 && curve.y[0] != curve.y[1]) return;  // a sloping line has no levels
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const QPointF point = area.pixel(curve.x[k], curve.y[k]);
    if (is_drawable(point)) draw_level_dash(painter, point, look);
  }
}

// Marks on the frame are whole, those beyond it are left out.
void draw_marks(QPainter& painter, const PlotArea& area, const Curve& curve, const Look& look) {
  constexpr double kRounding = 0.5;  // pixels
  const QRectF shown = area.rect.adjusted(-kRounding, -kRounding, kRounding, kRounding);
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const QPointF point = area.pixel(curve.x[k], curve.y[k]);
    if (is_drawable(point) && shown.contains(point)) draw_marker(painter, point, look);
  }
}

// Straight lines from point to point. A point between two gaps, which no line reaches, is a dot.
void draw_line(QPainter& painter, const PlotArea& area, const Curve& curve, const Look& look) {
  QPainterPath path;
  std::vector<QPolygonF> pieces(1);
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const QPointF point = area.pixel(curve.x[k], curve.y[k]);
    if (is_drawable(point))
      pieces.back() << point;
    else
      pieces.emplace_back();
  }
  for (const QPolygonF& piece : pieces)
    if (piece.size() > 1) path.addPolygon(piece);
  painter.setPen(curve_pen(look));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.colour);
  for (const QPolygonF& piece : pieces)
    if (piece.size() == 1) painter.drawEllipse(piece.front(), look.width, look.width);
}

void draw_error_bars(QPainter& painter, const PlotArea& area, const Curve& curve, const Look& look) {
  constexpr double kCap = 7;
  painter.setPen(QPen(look.colour, 2.5));
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

void draw_bars(QPainter& painter, const PlotArea& area, const Curve& curve, const Look& look) {
  QColor fill = look.colour;
  fill.setAlpha(150);
  painter.setBrush(fill);
  painter.setPen(QPen(look.colour, 2));
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

// One shaded ribbon for each piece of the curve without gaps.
void draw_band(QPainter& painter, const PlotArea& area, const Curve& curve, const Look& look) {
  QColor fill = look.colour;
  fill.setAlpha(55);
  painter.setPen(Qt::NoPen);
  painter.setBrush(fill);
  QPolygonF upper, lower;
  const auto close = [&] {
    std::reverse(lower.begin(), lower.end());
    if (upper.size() > 1) painter.drawPolygon(upper + lower);
    upper.clear();
    lower.clear();
  };
  for (std::size_t k = 0; k < curve.band.size(); ++k) {
    const QPointF top = area.pixel(curve.x[k], curve.y[k] + curve.band[k]);
    const QPointF foot = area.pixel(curve.x[k], curve.y[k] - curve.band[k]);
    if (is_drawable(top) && is_drawable(foot)) {
      upper << top;
      lower << foot;
    } else {
      close();
    }
  }
  close();
}

void draw_sample(QPainter& painter, const Curve& curve, const Look& look, double left, double middle) {
  if (curve.style == CurveStyle::kBars) {
    QColor fill = look.colour;
    fill.setAlpha(150);
    painter.setBrush(fill);
    painter.setPen(QPen(look.colour, 2));
    painter.drawRect(QRectF(left + 16, middle - 12, 32, 24));
    return;
  }
  if (curve.style != CurveStyle::kMarkers) {
    painter.setPen(curve_pen(look));
    painter.drawLine(QPointF(left, middle), QPointF(left + kSampleLength, middle));
  }
  if (has_marks(curve.style)) draw_marker(painter, {left + 0.5 * kSampleLength, middle}, look);
}

}  // namespace

QColor curve_colour(std::size_t index) {
  static const std::array<QColor, 8> kColours{
      QColor(0, 114, 178), QColor(213, 94, 0),   QColor(0, 158, 115), QColor(204, 121, 167),
      QColor(0, 0, 0),     QColor(86, 180, 233), QColor(230, 159, 0), QColor(130, 130, 130)};
  return kColours[index % kColours.size()];
}

bool has_marks(CurveStyle style) {
  return style == CurveStyle::kMarkers || style == CurveStyle::kLineAndMarkers;
}

void draw_curve(QPainter& painter, const PlotArea& area, const std::vector<Curve>& curves,
                std::size_t index) {
  const Curve& curve = curves[index];
  const Look look = look_of(curves, index);
  painter.save();
  clip_to_frame(painter, area);
  draw_band(painter, area, curve, look);
  if (curve.style == CurveStyle::kBars) {
    draw_bars(painter, area, curve, look);
  } else if (curve.style != CurveStyle::kMarkers) {
    draw_line(painter, area, curve, look);
  }
  draw_error_bars(painter, area, curve, look);
  if (curve.style == CurveStyle::kReference) draw_level_dashes(painter, area, curve, look);
  painter.restore();
  if (has_marks(curve.style)) draw_marks(painter, area, curve, look);
}

double draw_legend(QPainter* painter, const std::vector<Curve>& curves, double left, double top,
                   double width) {
  const LegendLayout legend = legend_layout(curves, width);
  const QFont font = text_font(legend.pixels);
  if (painter == nullptr) return static_cast<double>(legend.rows()) * legend.row_height();
  for (const LegendItem& entry : legend.entries) {
    const double x = left + entry.left, y = top + static_cast<double>(entry.row) * legend.row_height();
    draw_sample(*painter, curves[entry.curve], look_of(curves, entry.curve), x,
                y + 0.5 * legend.row_height());
    painter->setFont(font);
    painter->setPen(Qt::black);
    const QString name = QString::fromStdString(curves[entry.curve].name);
    painter->drawText(QRectF(x + kSampleLength + kTextGap, y, entry.room + 4, legend.row_height()),
                      Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetricsF(font).elidedText(name, Qt::ElideRight, entry.room + 1));
  }
  return static_cast<double>(legend.rows()) * legend.row_height();
}

}  // namespace diefill::render
