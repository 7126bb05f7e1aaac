#include "render/fields/arrow_painter.h"

#include <algorithm>
#include <cmath>

#include "render/style/text.h"
#include "render/style/ticks.h"

namespace diefill::render {
namespace {

constexpr double kLongest = 64;  // pixels that the legend arrow takes
constexpr double kMin = 5;       // pixels below which an arrow is a dot

QPolygonF head_of(const QPointF& tip, const QPointF& along, double length) {
  const QPointF across(-along.y(), along.x());
  return QPolygonF({tip, tip - length * along + 0.42 * length * across, tip - 0.75 * length * along,
                    tip - length * along - 0.42 * length * across});
}

// A white edge first, so that arrows show on dark and on bright ground.
void draw_arrow(QPainter& painter, const QPointF& foot, const QPointF& vector) {
  const double length = std::hypot(vector.x(), vector.y());
  if (length < kMin) {
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(Qt::black);
    painter.drawEllipse(foot, 2.5, 2.5);
    return;
  }
  const QPointF along = vector / length, tip = foot + vector;
  const double head = std::clamp(0.4 * length, 8.0, 18.0);
  const QPolygonF outline = head_of(tip, along, head);
  for (const auto& [colour, width] : {std::pair(Qt::white, 6.0), std::pair(Qt::black, 2.6)}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(foot, tip - 0.7 * head * along);
    painter.setPen(QPen(colour, width - 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(colour);
    painter.drawPolygon(outline);
  }
}

double longest(const std::vector<results::PlaneArrow>& arrows) {
  std::vector<double> lengths;
  for (const auto& arrow : arrows) lengths.push_back(std::hypot(arrow.along_first, arrow.along_second));
  std::sort(lengths.begin(), lengths.end());
  return lengths.empty() ? 0 : lengths[(lengths.size() - 1) * 97 / 100];
}

}  // namespace

double legend_arrow(const FieldStyle& style) {
  if (style.arrow_length > 0) return style.arrow_length;
  const double most = longest(style.arrows);
  if (!(most > 0)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most) return factor * power;
  return power;
}

void draw_arrows(QPainter& painter, const PlotArea& area, const FieldStyle& style) {
  if (style.arrows.empty()) return;
  const double known = legend_arrow(style), scale = kLongest / known;
  painter.save();
  painter.setClipRect(area.rect);
  for (const auto& arrow : style.arrows)
    draw_arrow(painter, area.pixel(arrow.first, arrow.second),
               {scale * arrow.along_first, -scale * arrow.along_second});
  const QString text = QString::fromStdString(tick_label(known, known) + " " + style.unit);
  const double width = text_width(text, text_font(kNotePixels)) + kLongest + 44;
  const QRectF box(area.rect.right() - width - 12, area.rect.top() + 12, width, 44);
  painter.setPen(QPen(Qt::black, 1.5));
  painter.setBrush(Qt::white);
  painter.drawRect(box);
  draw_arrow(painter, {box.left() + 14, box.center().y()}, {kLongest, 0});
  painter.setFont(text_font(kNotePixels));
  painter.setPen(Qt::black);
  painter.drawText(box.adjusted(kLongest + 28, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
  painter.restore();
}

}  // namespace diefill::render
