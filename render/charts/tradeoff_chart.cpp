#include "render/charts/tradeoff_chart.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/charts/tradeoff_marks.h"
#include "render/style/label_placement.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

using results::Tradeoff;
using results::TradeoffPoint;

constexpr double kWidth = 1600, kHeight = 1060, kMargin = 36, kRightMargin = 64;

struct Drawn {
  std::vector<std::size_t> points;
  std::vector<double> cost, error;  ///< core s, percent
};

Drawn drawable(const Tradeoff& tradeoff) {
  Drawn drawn;
  for (std::size_t k = 0; k < tradeoff.points.size(); ++k) {
    const TradeoffPoint& point = tradeoff.points[k];
    if (!(point.core_seconds > 0) || !std::isfinite(point.error)) continue;
    drawn.points.push_back(k);
    drawn.cost.push_back(point.core_seconds);
    drawn.error.push_back(100 * point.error);
  }
  if (drawn.points.empty()) throw std::runtime_error("no setting has both a cost and an error");
  return drawn;
}

/// From the least to the most, with room on both sides, and a factor of `least` at the least.
Interval with_room(double low, double high, double room, double least) {
  Interval range{low / room, high * room};
  const double widen = std::sqrt(std::max(1.0, least * range.lower / range.upper));
  return {range.lower / widen, range.upper * widen};
}

Interval cost_range(const Drawn& drawn) {
  const auto [low, high] = std::minmax_element(drawn.cost.begin(), drawn.cost.end());
  return with_room(*low, *high, 1.5, 10);
}

/// Down to a third of the floor, and below the smallest error, but no farther than a tenth of the floor:
/// smaller ones are as good as none.
Interval error_range(const Drawn& drawn, double floor) {
  double low = INFINITY, high = 0;
  for (const double error : drawn.error) {
    if (error > 0) low = std::min(low, 0.7 * error);
    high = std::max(high, error);
  }
  if (floor > 0) {
    low = std::clamp(low, 0.1 * floor, floor / 3);
    high = std::max(high, floor);
  }
  if (!(high > 0)) low = high = 1;
  return {std::max(low, high * 1e-5), 1.6 * high};
}

Axis logarithmic_axis(const QString& label, const Interval& range) {
  return {label, range, decade_ticks(range), true};
}

void draw_floor(QPainter& painter, const PlotArea& plot, double floor) {
  if (!(floor > 0)) return;
  const double top = std::max(plot.rect.top(), plot.pixel(plot.x.range.lower, floor).y());
  painter.fillRect(QRectF(QPointF(plot.rect.left(), top), plot.rect.bottomRight()), floor_colour());
}

/// Places of the points on the front, cheapest first.
std::vector<QPointF> front_of(const Tradeoff& tradeoff, const TradeoffPicture& picture) {
  std::vector<QPointF> front;
  for (std::size_t k = 0; k < picture.points.size(); ++k)
    if (tradeoff.points[picture.points[k]].pareto) front.push_back(picture.places[k]);
  std::sort(front.begin(), front.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
  return front;
}

void draw_front(QPainter& painter, const std::vector<QPointF>& front) {
  painter.setPen(QPen(front_colour(), 3));
  for (std::size_t k = 1; k < front.size(); ++k) painter.drawLine(front[k - 1], front[k]);
}

/// The front as small squares, for labels to keep off.
std::vector<QRectF> beads_along(const std::vector<QPointF>& front) {
  constexpr double kBead = 8;
  std::vector<QRectF> beads;
  for (std::size_t k = 1; k < front.size(); ++k) {
    const QPointF way = front[k] - front[k - 1];
    const int count = static_cast<int>(std::ceil(std::hypot(way.x(), way.y()) / kBead));
    for (int n = 0; n <= count; ++n) {
      const QPointF at = front[k - 1] + way * (static_cast<double>(n) / std::max(1, count));
      beads.emplace_back(at.x() - 0.5 * kBead, at.y() - 0.5 * kBead, kBead, kBead);
    }
  }
  return beads;
}

/// A thin line from a label to its mark, where it stands apart.
void draw_leader(QPainter& painter, const QRectF& label, const LabelledPoint& point) {
  const QLineF leader = leader_of(label, point);
  if (leader.length() < 14) return;
  painter.setPen(QPen(QColor(110, 110, 110), 1.5));
  painter.drawLine(leader);
}

/// Points, numbers into `picture.points`, whose marks lie on top of each other: they share a label. Cheapest
/// first.
std::vector<std::vector<std::size_t>> heaps_of(const TradeoffPicture& picture) {
  std::vector<std::vector<std::size_t>> heaps;
  for (std::size_t k = 0; k < picture.places.size(); ++k) {
    const auto near = [&](std::size_t other) {
      const QPointF way = picture.places[k] - picture.places[other];
      return std::hypot(way.x(), way.y()) < 2 * kMarkRadius;
    };
    const auto heap =
        std::ranges::find_if(heaps, [&](const auto& one) { return std::ranges::any_of(one, near); });
    if (heap == heaps.end())
      heaps.push_back({k});
    else
      heap->push_back(k);
  }
  for (auto& heap : heaps)
    std::ranges::stable_sort(heap, {}, [&](std::size_t k) { return picture.places[k].x(); });
  return heaps;
}

constexpr double kLine = 1.2 * kNotePixels;

QFont label_font(const TradeoffPoint& point) {
  return text_font(kNotePixels, point.recommended);
}

/// The label, shortened in the middle where it would take more than a third of the picture: names of variants
/// may be long, and differ at their beginnings or ends.
QString shown_label(const TradeoffPoint& point) {
  return QFontMetricsF(label_font(point))
      .elidedText(QString::fromStdString(point.label), Qt::ElideMiddle, kWidth / 3);
}

/// Room for the lines of a heap's label, at the mark that stands out most.
LabelledPoint labelled(const Tradeoff& tradeoff, const TradeoffPicture& picture,
                       const std::vector<std::size_t>& heap) {
  LabelledPoint made{{}, {0, kLine * static_cast<double>(heap.size())}, 0};
  for (const std::size_t k : heap) {
    const TradeoffPoint& point = tradeoff.points[picture.points[k]];
    const double width = text_width(shown_label(point), label_font(point)) + 2;
    made.label.setWidth(std::max(made.label.width(), width));
    if (mark_radius(point) <= made.radius) continue;
    made.radius = mark_radius(point);
    made.at = picture.places[k];
  }
  return made;
}

/// A line of text for each point of a heap, from the top.
void draw_lines(QPainter& painter, const Tradeoff& tradeoff, const TradeoffPicture& picture,
                const std::vector<std::size_t>& heap, const QRectF& label) {
  for (std::size_t n = 0; n < heap.size(); ++n) {
    const TradeoffPoint& point = tradeoff.points[picture.points[heap[n]]];
    painter.setFont(label_font(point));
    painter.setPen(point.recommended ? chosen_colour() : QColor(Qt::black));
    const QRectF line(label.left(), label.top() + kLine * static_cast<double>(n), label.width(), kLine);
    painter.drawText(line.adjusted(-2, -2, 2, 2), Qt::AlignCenter, shown_label(point));
  }
}

void draw_labels(QPainter& painter, const Tradeoff& tradeoff, TradeoffPicture& picture) {
  const auto heaps = heaps_of(picture);
  std::vector<LabelledPoint> points;
  for (const auto& heap : heaps) points.push_back(labelled(tradeoff, picture, heap));
  picture.labels = place_labels(points, picture.plot.rect.adjusted(6, 6, -6, -6),
                                beads_along(front_of(tradeoff, picture)));
  for (std::size_t k = 0; k < points.size(); ++k) {
    draw_leader(painter, picture.labels[k], points[k]);
    draw_lines(painter, tradeoff, picture, heaps[k], picture.labels[k]);
  }
}

/// Which errors are meant, and against what. `some_below`: there are settings with errors below the axis.
QString note_of(const Tradeoff& tradeoff, bool some_below) {
  QString names;
  bool target = false;
  for (const auto& quantity : tradeoff.quantities) {
    if (!quantity.decides || !std::isfinite(quantity.reference)) continue;
    names += (names.isEmpty() ? "" : ", ") + QString::fromStdString(quantity.name);
    target = target || quantity.is_target;
  }
  if (target) names += QStringLiteral(" (published values)");
  constexpr int kMostNamed = 2;
  QStringList missing;
  for (const TradeoffPoint& point : tradeoff.points) {
    if (point.reference) names += QStringLiteral("; against \"%1\"").arg(shown_label(point));
    if (point.state == "failed" || failed_with_a_seed(point)) missing << shown_label(point);
  }
  if (missing.size() > kMostNamed)
    names += QStringLiteral("; failed: %1 settings").arg(missing.size());
  else if (!missing.isEmpty())
    names += QStringLiteral("; failed: ") + missing.join(QStringLiteral(", "));
  if (some_below) names += QStringLiteral("; lower edge: that or less");
  return QStringLiteral("Largest error of: ") + names;
}

}  // namespace

TradeoffPicture compose_tradeoff(const Tradeoff& tradeoff) {
  const Drawn drawn = drawable(tradeoff);
  const double floor = 100 * tradeoff.floor;
  TradeoffPicture picture{white_canvas(static_cast<int>(kWidth), static_cast<int>(kHeight)), {}, {}, {}, {}};
  PlotArea& plot = picture.plot;
  plot.x = logarithmic_axis(QStringLiteral("Processor time of a run [core s]"), cost_range(drawn));
  plot.y = logarithmic_axis(QStringLiteral("Largest error [%]"), error_range(drawn, floor));
  const Heading heading(tradeoff.title, tradeoff.advice, kWidth - 2 * kMargin);
  const double left = kMargin + left_margin(plot.y), legend = kMargin + heading.height() + 8;
  plot.rect = QRectF(
      QPointF(std::round(left),
              std::round(legend + draw_mark_legend(nullptr, kMargin, legend, kWidth - 2 * kMargin, tradeoff) +
                         10)),
      QPointF(kWidth - kRightMargin, std::round(kHeight - kMargin - bottom_margin() - 44)));

  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  heading.draw(painter, kMargin, kMargin - 8);
  draw_mark_legend(&painter, kMargin, legend, kWidth - 2 * kMargin, tradeoff);
  draw_floor(painter, plot, floor);
  draw_grid(painter, plot);
  draw_axes(painter, plot, {kWidth, kHeight});
  picture.points = drawn.points;
  for (std::size_t k = 0; k < drawn.points.size(); ++k)
    picture.places.push_back(plot.pixel(drawn.cost[k], std::max(drawn.error[k], plot.y.range.lower)));
  draw_front(painter, front_of(tradeoff, picture));
  for (std::size_t k = 0; k < drawn.points.size(); ++k)
    draw_mark(painter, picture.places[k], tradeoff.points[drawn.points[k]]);
  draw_labels(painter, tradeoff, picture);
  const bool some_below = *std::ranges::min_element(drawn.error) < plot.y.range.lower;
  draw_centred(painter, {0.5 * kWidth, kHeight - kMargin - 8}, note_of(tradeoff, some_below), kNotePixels,
               kWidth - 2 * kMargin);
  return picture;
}

void draw_tradeoff(const std::filesystem::path& png, const Tradeoff& tradeoff) {
  write_png(png, compose_tradeoff(tradeoff).image);
}

}  // namespace diefill::render
