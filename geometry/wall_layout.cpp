#include "geometry/wall_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace diefill::geometry {

namespace {

/// Even steps from 0 to a length, none longer than the spacing.
struct Steps {
  int count;      ///< of points
  double length;  ///< of a step
};

Steps fit(double length, double spacing, bool closed) {
  // The small allowance keeps rounding from adding a step where the length is a multiple of the spacing.
  const int intervals = static_cast<int>(std::ceil(length / spacing - 1e-9));
  if (closed) return {std::max(3, intervals), length / std::max(3, intervals)};
  if (intervals <= 0) return {1, 0};
  return {intervals + 1, length / intervals};
}

}  // namespace

WallLayout::WallLayout(const OffsetSurface& offset, double spacing,
                       std::function<bool(const Eigen::Vector3d& foot)> wanted)
    : offset_(offset), spacing_(spacing), wanted_(std::move(wanted)), centres_(2 * spacing) {}

std::optional<OffsetSurface::Place> WallLayout::add(const Eigen::Vector3d& guess, const Eigen::Vector3d& foot,
                                                    double least_distance) {
  if (!wanted_(foot)) return std::nullopt;
  const std::optional<OffsetSurface::Place> place = offset_.settle(guess);
  if (!place || centres_.any_within(place->centre, least_distance)) return std::nullopt;
  centres_.insert(place->centre);
  return place;
}

void WallLayout::add_grid(const Strip& strip) {
  const Steps u = fit(strip.length, spacing_, strip.closed);
  const Steps v = fit(strip.high - strip.low, spacing_, false);
  double smallest_step = spacing_;
  if (u.length > 0) smallest_step = std::min(smallest_step, u.length);
  if (v.length > 0) smallest_step = std::min(smallest_step, v.length);
  const double least_distance = std::min(kLeastDistance * spacing_, 0.9 * smallest_step);
  for (int i = 0; i < u.count; ++i)
    for (int j = 0; j < v.count; ++j) {
      const StripPoint point = strip.at(i * u.length, strip.low + j * v.length, offset_.depth());
      add(point.centre, point.foot, least_distance);
    }
}

double WallLayout::distance_to_nearest(const Eigen::Vector3d& place, double limit) const {
  const std::size_t nearest = centres_.nearest_within(place, limit);
  return nearest == PointGrid::kNone ? limit : (centres_.points()[nearest] - place).norm();
}

}  // namespace diefill::geometry
