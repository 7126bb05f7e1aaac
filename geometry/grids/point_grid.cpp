#include "geometry/grids/point_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace diefill::geometry {

namespace {

constexpr std::size_t kFirstBuckets = 1024;
/// More than a square root and a product can be wrong by.
constexpr double kRounding = 1e-12;

}  // namespace

PointGrid::PointGrid(double cell) : inverse_cell_(1 / cell), heads_(kFirstBuckets, kEnd) {}

std::size_t PointGrid::insert(const Eigen::Vector3d& point) {
  if (points_.size() >= heads_.size()) resize(4 * heads_.size());
  const auto index = static_cast<std::uint32_t>(points_.size());
  points_.push_back(point);
  const Eigen::Vector3i cell = cell_of(point);
  std::uint32_t& head = heads_[bucket(cell)];
  links_.push_back({cell, head});
  head = index;
  return index;
}

std::size_t PointGrid::nearest_within(const Eigen::Vector3d& place, double radius) const {
  std::size_t best = kNone;
  double best_distance = std::numeric_limits<double>::infinity();
  const auto compare = [&](std::size_t index) {
    const double distance = (points_[index] - place).squaredNorm();
    if (distance < best_distance || (distance == best_distance && index < best)) {
      best = index;
      best_distance = distance;
    }
    return false;
  };
  // The points in the cell of the place itself bound how far to search.
  find_in_cell(cell_of(place), compare);
  const double bound = std::sqrt(best_distance) * (1 + kRounding);
  find_cell(place, std::min(radius, bound),
            [&](const Eigen::Vector3i& cell) { return find_in_cell(cell, compare); });
  return best_distance <= radius * radius ? best : kNone;
}

std::size_t PointGrid::some_within(const Eigen::Vector3d& place, double radius) const {
  const double radius_squared = radius * radius;
  std::size_t some = kNone;
  const auto near = [&](std::size_t index) {
    if ((points_[index] - place).squaredNorm() > radius_squared) return false;
    some = index;
    return true;
  };
  if (!find_in_cell(cell_of(place), near))
    find_cell(place, radius, [&](const Eigen::Vector3i& cell) { return find_in_cell(cell, near); });
  return some;
}

void PointGrid::reserve(std::size_t count) {
  points_.reserve(count);
  links_.reserve(count);
  if (count > heads_.size()) resize(std::bit_ceil(count));
}

void PointGrid::resize(std::size_t buckets) {
  heads_.assign(buckets, kEnd);
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    std::uint32_t& head = heads_[bucket(links_[i].cell)];
    links_[i].next = head;
    head = i;
  }
}

}  // namespace diefill::geometry
