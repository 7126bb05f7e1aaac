#include "geometry/grids/near_points.h"

#include <limits>

#include "geometry/grids/cell_index.h"

namespace diefill::geometry {

namespace {

/// More than rounding can amount to, relative to the length.
constexpr double kRounding = 1e-9;

}  // namespace

NearPoints::NearPoints(const PointGrid& grid, double radius, double edge)
    : grid_(grid), radius_(radius), edge_(edge), seen_(grid.points().size()) {}

std::size_t NearPoints::nearest_within(const Eigen::Vector3d& place, double radius) {
  std::size_t best = PointGrid::kNone;
  double best_distance = std::numeric_limits<double>::infinity();
  for_each_within(place, radius, [&](std::size_t index, double distance) {
    if (distance > best_distance || (distance == best_distance && index > best)) return;
    best = index;
    best_distance = distance;
  });
  return best;
}

bool NearPoints::any_within(const Eigen::Vector3d& place, double radius) {
  if (radius > radius_) return grid_.any_within(place, radius);
  Cube& cube = round(place);
  const auto near = [&](std::size_t k) {
    return (cube.points[k].point - place).squaredNorm() <= radius * radius;
  };
  // What is near one place is usually near the next.
  if (cube.last_found < cube.points.size() && near(cube.last_found)) return true;
  for (std::size_t k = 0; k < cube.points.size(); ++k) {
    if (!near(k)) continue;
    cube.last_found = k;
    return true;
  }
  return false;
}

NearPoints::Cube& NearPoints::round(const Eigen::Vector3d& place) {
  if (seen_ != grid_.points().size()) {
    for (Cube& cube : cubes_) cube.filled = false;
    seen_ = grid_.points().size();
  }
  const Eigen::Vector3i number = cube_of(place / edge_);
  Cube& cube = cubes_.at(number);
  if (!cube.filled || cube.number != number) {
    cube.number = number;
    fill(cube);
  }
  return cube;
}

void NearPoints::fill(Cube& cube) const {
  const Eigen::Vector3d middle = (cube.number.cast<double>().array() + 0.5) * edge_;
  cube.points.clear();
  grid_.for_each_in_cube(middle, (edge_ / 2 + radius_) * (1 + kRounding), [&](std::size_t index) {
    cube.points.push_back({grid_.points()[index], index});
  });
  cube.filled = true;
  cube.last_found = 0;
}

}  // namespace diefill::geometry
