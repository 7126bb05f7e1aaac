#include "render/style/label_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diefill::render {
namespace {

constexpr int kDirections = 16, kDistances = 9, kSweeps = 6;
constexpr double kGap = 6, kStep = 22;  // pixels: to the mark, from one distance to the next
constexpr double kCovering = 1e3;       // price of a covered pixel against one of distance
constexpr double kCrossing = 2e4;       // price of a leader through a label

double covered(const QRectF& a, const QRectF& b) {
  const QRectF both = a.intersected(b);
  return both.isEmpty() ? 0 : both.width() * both.height();
}

/// The label beyond the mark in a direction, touching a circle round it from outside.
QRectF candidate(const LabelledPoint& point, int direction, int distance) {
  const double angle = 2 * std::numbers::pi * direction / kDirections;
  const double x = std::cos(angle), y = -std::sin(angle);
  const double reach = point.radius + kGap + kStep * distance;
  const QPointF centre =
      point.at + QPointF(x * (reach + 0.5 * point.label.width()), y * (reach + 0.5 * point.label.height()));
  return {centre.x() - 0.5 * point.label.width(), centre.y() - 0.5 * point.label.height(),
          point.label.width(), point.label.height()};
}

/// Whether a line goes through a rectangle; looked at every few pixels.
bool crosses(const QLineF& line, const QRectF& area) {
  constexpr double kEvery = 4;
  const int count = static_cast<int>(line.length() / kEvery);
  for (int n = 0; n <= count && count > 0; ++n)
    if (area.contains(line.pointAt(static_cast<double>(n) / count))) return true;
  return false;
}

/// Pixels of distance, and far more for every pixel of something else that is covered and every leader
/// across.
double price(const QRectF& label, std::size_t own, const std::vector<LabelledPoint>& points,
             const std::vector<QRectF>& labels, const std::vector<QRectF>& taken) {
  const QRectF room = label.adjusted(-3, -1, 3, 1);
  const QLineF leader = leader_of(label, points[own]);
  double sum = std::hypot(label.center().x() - points[own].at.x(), label.center().y() - points[own].at.y());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double r = points[k].radius + 2;
    sum += kCovering * covered(room, QRectF(points[k].at.x() - r, points[k].at.y() - r, 2 * r, 2 * r));
    if (k == own || labels[k].isEmpty()) continue;
    sum += kCovering * covered(room, labels[k]);
    if (crosses(leader, labels[k])) sum += kCrossing;
    if (crosses(leader_of(labels[k], points[k]), room)) sum += kCrossing;
  }
  for (const QRectF& other : taken) sum += kCovering * covered(room, other);
  return sum;
}

QRectF best_place(std::size_t own, const std::vector<LabelledPoint>& points, const QRectF& area,
                  const std::vector<QRectF>& labels, const std::vector<QRectF>& taken) {
  QRectF best;
  double least = INFINITY;
  for (int distance = 0; distance < kDistances; ++distance)
    for (int direction = 0; direction < kDirections; ++direction) {
      const QRectF place = candidate(points[own], direction, distance);
      if (!area.contains(place)) continue;
      const double asked = price(place, own, points, labels, taken);
      if (asked >= least) continue;
      least = asked;
      best = place;
    }
  if (std::isfinite(least)) return best;
  // A label wider than the room left of and right of its point: as far inside as goes.
  QRectF inside = candidate(points[own], kDirections / 4, 0);
  inside.moveLeft(
      std::clamp(inside.left(), area.left(), std::max(area.left(), area.right() - inside.width())));
  inside.moveTop(std::clamp(inside.top(), area.top(), std::max(area.top(), area.bottom() - inside.height())));
  return inside;
}

}  // namespace

QLineF leader_of(const QRectF& label, const LabelledPoint& point) {
  const QPointF nearest(std::clamp(point.at.x(), label.left(), label.right()),
                        std::clamp(point.at.y(), label.top(), label.bottom()));
  QLineF whole(point.at, nearest);
  if (whole.length() <= point.radius) return {nearest, nearest};
  return {whole.pointAt(point.radius / whole.length()), nearest};
}

std::vector<QRectF> place_labels(const std::vector<LabelledPoint>& points, const QRectF& area,
                                 const std::vector<QRectF>& taken) {
  std::vector<QRectF> labels(points.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t k = 0; k < points.size(); ++k) labels[k] = best_place(k, points, area, labels, taken);
  return labels;
}

}  // namespace diefill::render
