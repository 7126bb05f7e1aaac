#include "render/fields/field_marks.h"

#include <array>
#include <cmath>

#include "render/style/star.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kStarSize = 20, kRowHeight = 46;  // pixels
const QColor kStarColour(213, 94, 0);

void draw_star(QPainter& painter, const QPointF& at) {
  // White, and black around it: one of the two stands out from any colour of the scale.
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 8, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawPolygon(star_outline(at, kStarSize));
  painter.setBrush(kStarColour);
  painter.setPen(QPen(Qt::white, 5, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawPolygon(star_outline(at, kStarSize));
}

void draw_line_pieces(QPainter& painter, const std::vector<QLineF>& pieces) {
  for (const auto& [colour, width] : {std::pair{QColor(Qt::white), 8.0}, {QColor(Qt::black), 4.0}}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    for (const QLineF& piece : pieces) painter.drawLine(piece);
  }
}

/// Where a cell's edges have the level, by linear interpolation, in the order of the edges.
std::vector<QPointF> crossings_of(const results::Field2D& field, std::size_t i, std::size_t j, double level) {
  constexpr std::array<std::array<std::size_t, 2>, 5> kAround = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
  std::vector<QPointF> crossings;
  const auto value = [&](const auto& corner) {
    return field.value[(j + corner[1]) * field.first.size() + i + corner[0]];
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const auto &from = kAround[k], &to = kAround[k + 1];
    const double before = value(from), after = value(to);
    if (!std::isfinite(before) || !std::isfinite(after) || (before < level) == (after < level)) continue;
    const double share = (level - before) / (after - before);
    const QPointF start(field.first[i + from[0]], field.second[j + from[1]]);
    const QPointF end(field.first[i + to[0]], field.second[j + to[1]]);
    crossings.push_back(start + share * (end - start));
  }
  return crossings;
}

/// The line of one level, cell by cell, in pixels.
std::vector<QLineF> level_line(const PlotArea& plot, const results::Field2D& field, double level) {
  std::vector<QLineF> pieces;
  for (std::size_t j = 0; j + 1 < field.second.size(); ++j)
    for (std::size_t i = 0; i + 1 < field.first.size(); ++i) {
      const auto crossings = crossings_of(field, i, j, level);
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        pieces.emplace_back(plot.pixel(crossings[k].x(), crossings[k].y()),
                            plot.pixel(crossings[k + 1].x(), crossings[k + 1].y()));
    }
  return pieces;
}

/// Writes what a sample of 56 pixels means; returns where the next one begins.
double draw_meaning(QPainter& painter, double left, double middle, const std::string& meaning) {
  constexpr double kBesideSample = 66, kBetween = 36;
  const QFont font = text_font(kNotePixels);
  const QString text = QString::fromStdString(meaning);
  const double width = text_width(text, font) + 4;
  painter.setFont(font);
  painter.setPen(Qt::black);
  painter.drawText(QRectF(left + kBesideSample, middle - 20, width, 40), Qt::AlignLeft | Qt::AlignVCenter,
                   text);
  return left + kBesideSample + width + kBetween;
}

}  // namespace

void draw_field_marks(QPainter& painter, const PlotArea& plot, const results::Field2D& field,
                      const FieldStyle& style) {
  painter.save();
  painter.setClipRect(plot.rect.adjusted(-kStarSize, -kStarSize, kStarSize, kStarSize));
  for (const LevelLine& line : style.level_lines)
    draw_line_pieces(painter, level_line(plot, field, line.level));
  for (const StarMark& star : style.stars) draw_star(painter, plot.pixel(star.place.x(), star.place.y()));
  painter.restore();
}

double marks_legend_height(const FieldStyle& style) {
  return style.stars.empty() && style.level_lines.empty() ? 0 : kRowHeight;
}

void draw_marks_legend(QPainter& painter, const QPointF& corner, const FieldStyle& style) {
  const double middle = corner.y() + 0.5 * kRowHeight;
  double left = corner.x();
  for (const StarMark& star : style.stars) {
    draw_star(painter, {left + 28, middle});
    left = draw_meaning(painter, left, middle, star.meaning);
  }
  for (const LevelLine& line : style.level_lines) {
    draw_line_pieces(painter, {{QPointF(left + 4, middle), QPointF(left + 52, middle)}});
    left = draw_meaning(painter, left, middle, line.meaning);
  }
}

}  // namespace diefill::render
