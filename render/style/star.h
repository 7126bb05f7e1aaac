// The star that marks the best of many points.
#pragma once

#include <QPolygonF>
#include <cmath>
#include <numbers>

namespace diefill::render {

/// Five points, one of them up.
inline QPolygonF star_outline(const QPointF& centre, double radius) {
  QPolygonF outline;
  for (int k = 0; k < 10; ++k) {
    const double r = k % 2 == 0 ? radius : 0.45 * radius, angle = std::numbers::pi * (0.2 * k - 0.5);
    outline << centre + QPointF(r * std::cos(angle), r * std::sin(angle));
  }
  return outline;
}

}  // namespace diefill::render
