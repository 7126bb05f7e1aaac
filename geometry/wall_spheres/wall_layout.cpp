#include "geometry/wall_spheres/wall_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/grids/all_cores.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kAtATime = 1 << 19;  // places of a grid

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
  return keep(settled(guess, foot), least_distance);
}

std::optional<OffsetSurface::Place> WallLayout::settled(const Eigen::Vector3d& guess,
                                                        const Eigen::Vector3d& foot) const {
  if (!wanted_(foot)) return std::nullopt;
  return offset_.settle(guess, foot);
}

std::optional<OffsetSurface::Place> WallLayout::keep(const std::optional<OffsetSurface::Place>& place,
                                                     double least_distance) {
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
  const double least_distance = std::min(kMinDistance * spacing_, 0.9 * smallest_step);
  const std::size_t across = static_cast<std::size_t>(v.count);
  const std::size_t all = static_cast<std::size_t>(u.count) * across;
  std::vector<std::optional<OffsetSurface::Place>> places;
  for (std::size_t begin = 0; begin < all; begin += places.size()) {
    places.assign(std::min(kAtATime, all - begin), std::nullopt);
    in_parts_on_all_cores(places.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k) {
        const auto i = static_cast<double>((begin + k) / across),
                   j = static_cast<double>((begin + k) % across);
        const StripPoint point = strip.at(i * u.length, strip.low + j * v.length, offset_.depth());
        places[k] = settled(point.centre, point.foot);
      }
    });
    for (const auto& place : places) keep(place, least_distance);
  }
}

}  // namespace diefill::geometry
