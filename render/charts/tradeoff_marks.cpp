#include "render/charts/tradeoff_marks.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "render/style/star.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

using results::Tradeoff;
using results::TradeoffPoint;

constexpr double kLegendRow = 46;
const QColor kPointColour(120, 130, 145), kFailedColour(90, 90, 90);

/// What a legend explains, and its sample.
struct LegendEntry {
  QString text;
  std::function<void(QPainter&, const QPointF&)> sample;
};

/// A mark as points with these properties have it.
LegendEntry mark_entry(const QString& text, const TradeoffPoint& point) {
  return {text, [point](QPainter& painter, const QPointF& at) { draw_mark(painter, at, point); }};
}

std::vector<LegendEntry> legend_of(const Tradeoff& tradeoff) {
  TradeoffPoint chosen, reference, front, off, failed;
  chosen.recommended = reference.reference = front.pareto = true;
  off.beyond = {"some quantity"};
  failed.reason = "some reason";
  const auto any = [&](const auto& is) { return std::ranges::any_of(tradeoff.points, is); };
  std::vector<LegendEntry> entries;
  if (any([](const TradeoffPoint& point) { return point.recommended; }))
    entries.push_back(mark_entry(QStringLiteral("recommended"), chosen));
  const std::vector<LegendEntry> always = {
      {QStringLiteral("Pareto-optimal"),
       [front](QPainter& painter, const QPointF& at) {
         painter.setPen(QPen(front_colour(), 3));
         painter.drawLine(at - QPointF(26, 0), at + QPointF(26, 0));
         draw_mark(painter, at, front);
       }},
      mark_entry(QStringLiteral("reference"), reference),
  };
  entries.insert(entries.end(), always.begin(), always.end());
  if (any([](const TradeoffPoint& point) { return !point.beyond.empty(); }))
    entries.push_back(mark_entry(QStringLiteral("error above limit"), off));
  if (any([](const TradeoffPoint& point) { return failed_with_a_seed(point); }))
    entries.push_back(mark_entry(QStringLiteral("failed with a seed"), failed));
  if (tradeoff.floor > 0)
    entries.push_back({QStringLiteral("scatter over seeds"), [](QPainter& painter, const QPointF& at) {
                         painter.setPen(Qt::NoPen);
                         painter.setBrush(floor_colour());
                         painter.drawRect(QRectF(at.x() - 26, at.y() - 14, 52, 28));
                       }});
  return entries;
}

}  // namespace

QColor floor_colour() {
  return {232, 232, 226};
}

QColor front_colour() {
  return {0, 114, 178};
}

QColor chosen_colour() {
  return {213, 94, 0};
}

bool failed_with_a_seed(const TradeoffPoint& point) {
  return point.seeds > 0 && !point.reason.empty();
}

void draw_mark(QPainter& painter, const QPointF& at, const TradeoffPoint& point) {
  painter.setPen(QPen(Qt::white, 1.5));
  if (point.recommended) {
    painter.setBrush(chosen_colour());
    painter.drawPolygon(star_outline(at, kStarRadius));
  } else if (!point.reason.empty()) {
    constexpr double kArm = 0.85 * kMarkRadius;
    painter.setPen(QPen(kFailedColour, 5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at - QPointF(kArm, kArm), at + QPointF(kArm, kArm));
    painter.drawLine(at - QPointF(kArm, -kArm), at + QPointF(kArm, -kArm));
  } else if (point.beyond.empty()) {
    painter.setBrush(point.pareto ? front_colour() : kPointColour);
    painter.drawEllipse(at, kMarkRadius, kMarkRadius);
  } else {
    constexpr double kRing = 5;
    painter.setPen(QPen(point.pareto ? front_colour() : kPointColour, kRing));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, kMarkRadius - 0.5 * kRing, kMarkRadius - 0.5 * kRing);
  }
  if (!point.reference) return;
  painter.setPen(QPen(Qt::black, 3));
  painter.setBrush(Qt::NoBrush);
  const double r = point.recommended ? kStarRadius + 4 : kMarkRadius + 6;
  painter.drawEllipse(at, r, r);
}

double mark_radius(const TradeoffPoint& point) {
  return point.recommended ? kStarRadius : kMarkRadius + (point.reference ? 7 : 0);
}

double draw_mark_legend(QPainter* painter, double first, double top, double room, const Tradeoff& tradeoff) {
  constexpr double kSample = 56, kGap = 20;
  const QFont font = text_font(kNotePixels);
  double left = first, middle = top + 0.5 * kLegendRow;
  for (const LegendEntry& entry : legend_of(tradeoff)) {
    const double width = kSample + 8 + text_width(entry.text, font) + 4;
    if (left > first && left + width > first + room) {
      left = first;
      middle += kLegendRow;
    }
    if (painter != nullptr) {
      entry.sample(*painter, {left + 0.5 * kSample, middle});
      painter->setFont(font);
      painter->setPen(Qt::black);
      painter->drawText(QRectF(left + kSample + 8, middle - 20, width, 40), Qt::AlignLeft | Qt::AlignVCenter,
                        entry.text);
    }
    left += width + kGap;
  }
  return middle + 0.5 * kLegendRow - top;
}

}  // namespace diefill::render
