#include "geometry/voronoi/neighbour_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::geometry {
namespace {

/// Adds the images of all points so far along one axis.
void add_images_along(PointImages& images, int axis, double period, double margin) {
  const int shells = static_cast<int>(std::ceil(margin / period));
  const std::size_t originals = images.points.size();
  for (int shell = -shells; shell <= shells; ++shell) {
    if (shell == 0) continue;
    for (std::size_t n = 0; n < originals; ++n) {
      Eigen::Vector3d image = images.points[n];
      image[axis] += shell * period;
      if (std::abs(image[axis]) > 0.5 * period + margin) continue;
      images.points.push_back(image);
      images.source.push_back(images.source[n]);
    }
  }
}

}  // namespace

PointImages with_periodic_images(const std::vector<Eigen::Vector3d>& points,
                                 const std::array<std::optional<double>, 3>& period, double margin) {
  PointImages images{points, {}};
  images.source.resize(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) images.source[n] = static_cast<std::uint32_t>(n);
  for (int axis = 0; axis < 3; ++axis) {
    if (!period[axis]) continue;
    const double length = *period[axis];
    if (!(length > 0)) throw std::invalid_argument("a periodic length must be positive");
    for (auto& point : images.points) point[axis] -= length * std::round(point[axis] / length);
    add_images_along(images, axis, length, margin);
  }
  return images;
}

NeighbourGrid::NeighbourGrid(const std::vector<Eigen::Vector3d>& points, double spacing) {
  if (points.empty()) return;
  if (!(spacing > 0)) throw std::invalid_argument("the cells of a neighbour grid need a positive edge");
  Eigen::Array3d upper = points.front().array();
  lower_ = upper;
  for (const auto& point : points) {
    lower_ = lower_.min(point.array());
    upper = upper.max(point.array());
  }
  const Eigen::Array3d extent = upper - lower_;
  const double most_cells = 4.0 * static_cast<double>(points.size()) + 64.0;
  edge_ = Eigen::Array3d::Constant(spacing);
  Eigen::Array3d wanted = (extent / edge_).floor() + 1.0;
  while (wanted.prod() > most_cells) {
    edge_ *= 1.25;
    wanted = (extent / edge_).floor() + 1.0;
  }
  cells_ = wanted.cast<int>();

  const auto number_of = [&](const Eigen::Vector3d& point) {
    const Eigen::Array3i cell = cell_of(point.array());
    return (static_cast<std::size_t>(cell.z()) * cells_.y() + cell.y()) * cells_.x() + cell.x();
  };
  start_.assign(static_cast<std::size_t>(wanted.prod()) + 1, 0);
  for (const auto& point : points) ++start_[number_of(point) + 1];
  for (std::size_t cell = 1; cell < start_.size(); ++cell) start_[cell] += start_[cell - 1];
  index_.resize(points.size());
  points_.resize(points.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const std::uint32_t place = next[number_of(points[n])]++;
    index_[place] = static_cast<std::uint32_t>(n);
    points_[place] = points[n];
  }
}

}  // namespace diefill::geometry
