#include "render/charts/tradeoff_chart.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "render/style/label_placement.h"
#include "render/style/picture_file.h"
#include "render/style/star.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

using results::Tradeoff;
using results::TradeoffPoint;

constexpr double kWidth = 1600, kHeight = 1060, kMargin = 36, kRightMargin = 64;
constexpr double kLegendRow = 46;
constexpr double kRadius = 11, kStarRadius = 24;
const QColor kFloorColour(232, 232, 226), kPoint(120, 130, 145), kFront(0, 114, 178), kChosen(213, 94, 0),
    kFailed(90, 90, 90);

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

/// Some runs of the setting are finished and some have failed.
bool failed_with_a_seed(const TradeoffPoint& point) {
  return point.seeds > 0 && !point.reason.empty();
}

void draw_mark(QPainter& painter, const QPointF& at, const TradeoffPoint& point) {
  painter.setPen(QPen(Qt::white, 1.5));
  if (point.recommended) {
    painter.setBrush(kChosen);
    painter.drawPolygon(star_outline(at, kStarRadius));
  } else if (!point.reason.empty()) {
    constexpr double kArm = 0.85 * kRadius;
    painter.setPen(QPen(kFailed, 5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at - QPointF(kArm, kArm), at + QPointF(kArm, kArm));
    painter.drawLine(at - QPointF(kArm, -kArm), at + QPointF(kArm, -kArm));
  } else if (point.beyond.empty()) {
    painter.setBrush(point.pareto ? kFront : kPoint);
    painter.drawEllipse(at, kRadius, kRadius);
  } else {
    constexpr double kRing = 5;
    painter.setPen(QPen(point.pareto ? kFront : kPoint, kRing));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, kRadius - 0.5 * kRing, kRadius - 0.5 * kRing);
  }
  if (!point.reference) return;
  painter.setPen(QPen(Qt::black, 3));
  painter.setBrush(Qt::NoBrush);
  const double r = point.recommended ? kStarRadius + 4 : kRadius + 6;
  painter.drawEllipse(at, r, r);
}

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
         painter.setPen(QPen(kFront, 3));
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
                         painter.setBrush(kFloorColour);
                         painter.drawRect(QRectF(at.x() - 26, at.y() - 14, 52, 28));
                       }});
  return entries;
}

void draw_legend_row(QPainter& painter, double left, double middle, const Tradeoff& tradeoff) {
  constexpr double kSample = 56, kGap = 20;
  const QFont font = text_font(kNotePixels);
  for (const LegendEntry& entry : legend_of(tradeoff)) {
    entry.sample(painter, {left + 0.5 * kSample, middle});
    painter.setFont(font);
    painter.setPen(Qt::black);
    const double width = text_width(entry.text, font) + 4;
    painter.drawText(QRectF(left + kSample + 8, middle - 20, width, 40), Qt::AlignLeft | Qt::AlignVCenter,
                     entry.text);
    left += kSample + 8 + width + kGap;
  }
}

void draw_floor(QPainter& painter, const PlotArea& plot, double floor) {
  if (!(floor > 0)) return;
  const double top = std::max(plot.rect.top(), plot.pixel(plot.x.range.lower, floor).y());
  painter.fillRect(QRectF(QPointF(plot.rect.left(), top), plot.rect.bottomRight()), kFloorColour);
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
  painter.setPen(QPen(kFront, 3));
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

double mark_radius(const TradeoffPoint& point) {
  return point.recommended ? kStarRadius : kRadius + (point.reference ? 7 : 0);
}

/// Points, numbers into `picture.points`, whose marks lie on top of each other: they share a label. Cheapest
/// first.
std::vector<std::vector<std::size_t>> heaps_of(const TradeoffPicture& picture) {
  std::vector<std::vector<std::size_t>> heaps;
  for (std::size_t k = 0; k < picture.places.size(); ++k) {
    const auto near = [&](std::size_t other) {
      const QPointF way = picture.places[k] - picture.places[other];
      return std::hypot(way.x(), way.y()) < 2 * kRadius;
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

/// Room for the lines of a heap's label, at the mark that stands out most.
LabelledPoint labelled(const Tradeoff& tradeoff, const TradeoffPicture& picture,
                       const std::vector<std::size_t>& heap) {
  LabelledPoint made{{}, {0, kLine * static_cast<double>(heap.size())}, 0};
  for (const std::size_t k : heap) {
    const TradeoffPoint& point = tradeoff.points[picture.points[k]];
    const double width =
        text_width(QString::fromStdString(point.label), text_font(kNotePixels, point.recommended)) + 2;
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
    painter.setFont(text_font(kNotePixels, point.recommended));
    painter.setPen(point.recommended ? kChosen : QColor(Qt::black));
    const QRectF line(label.left(), label.top() + kLine * static_cast<double>(n), label.width(), kLine);
    painter.drawText(line.adjusted(-2, -2, 2, 2), Qt::AlignCenter, QString::fromStdString(point.label));
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
  QString missing;
  for (const TradeoffPoint& point : tradeoff.points) {
    if (point.reference) names += QStringLiteral("; against \"%1\"").arg(QString::fromStdString(point.label));
    if (point.state == "failed" || failed_with_a_seed(point))
      missing += (missing.isEmpty() ? "" : ", ") + QString::fromStdString(point.label);
  }
  if (!missing.isEmpty()) names += QStringLiteral("; failed: ") + missing;
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
  plot.rect = QRectF(QPointF(std::round(left), std::round(legend + kLegendRow + 10)),
                     QPointF(kWidth - kRightMargin, std::round(kHeight - kMargin - bottom_margin() - 44)));

  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  heading.draw(painter, kMargin, kMargin - 8);
  draw_legend_row(painter, kMargin, legend + 0.5 * kLegendRow, tradeoff);
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
