#include "engine/walls/triangle_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace diefill::engine {

namespace {

/// Cells of a body are limited to this number; larger cells then make up for it.
constexpr double kMaxCells = 1.6e7;

}  // namespace

TriangleCells::TriangleCells(const std::vector<WallTriangle>& triangles, double reach) : cell_size_(reach) {
  if (triangles.empty()) return;
  lower_ = triangles.front().corner[0];
  Eigen::Vector3d upper = lower_;
  for (const auto& triangle : triangles)
    for (const auto& corner : triangle.corner) {
      lower_ = lower_.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
  const Eigen::Vector3d room = upper - lower_ + Eigen::Vector3d::Constant(reach);
  while (room.prod() / (cell_size_ * cell_size_ * cell_size_) > kMaxCells) cell_size_ *= 1.2;
  for (int axis = 0; axis < 3; ++axis)
    cells_[axis] = static_cast<int>(std::floor((upper[axis] - lower_[axis]) / cell_size_)) + 1;

  first_.assign(static_cast<std::size_t>(cells_.cast<double>().prod()) + 1, 0);
  for (const auto& triangle : triangles) visit_cells(triangle, [&](std::size_t cell) { ++first_[cell + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  triangle_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    visit_cells(triangles[t], [&](std::size_t cell) { triangle_[next[cell]++] = t; });
}

Eigen::Vector3i TriangleCells::cell_of(const Eigen::Vector3d& place) const {
  // Far places are clamped before the conversion to integers, whose range is smaller.
  const Eigen::Array3d cell = ((place - lower_) / cell_size_).array().floor();
  return cell.max(-1.0).min(cells_.cast<double>().array()).cast<int>();
}

std::size_t TriangleCells::index_of(int x, int y, int z) const {
  return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(cells_[0]) +
         static_cast<std::size_t>(x);
}

/// Calls visit(index) for the cells that the triangle passes through, and for some more at its rim.
template <class Visit>
void TriangleCells::visit_cells(const WallTriangle& triangle, const Visit& visit) const {
  const auto& [a, b, c] = triangle.corner;
  const Eigen::Vector3i low = cell_of(a.cwiseMin(b).cwiseMin(c)).cwiseMax(0);
  const Eigen::Vector3i high = cell_of(a.cwiseMax(b).cwiseMax(c)).cwiseMin(cells_ - Eigen::Vector3i::Ones());
  const double within = 0.8661 * cell_size_;  // from the middle of a cell to its corners, rounded up
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const Eigen::Vector3d middle = lower_ + cell_size_ * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
        if ((nearest_point(triangle, middle).point - middle).squaredNorm() <= within * within)
          visit(index_of(x, y, z));
      }
}

void TriangleCells::find(const std::vector<WallTriangle>& triangles, const Eigen::Vector3d& place,
                         double reach, std::vector<std::uint32_t>& found) const {
  if (triangle_.empty()) return;
  const Eigen::Vector3d to = Eigen::Vector3d::Constant(reach);
  const Eigen::Vector3i low = cell_of(place - to).cwiseMax(0);
  const Eigen::Vector3i high = cell_of(place + to).cwiseMin(cells_ - Eigen::Vector3i::Ones());
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y) {
      if (high[0] < low[0]) return;
      // Cells along x lie together.
      const std::uint32_t begin = first_[index_of(low[0], y, z)];
      const std::uint32_t end = first_[index_of(high[0], y, z) + 1];
      found.insert(found.end(), triangle_.begin() + begin, triangle_.begin() + end);
    }
  std::sort(found.begin() + before, found.end());
  found.erase(std::unique(found.begin() + before, found.end()), found.end());
  const auto far = [&](std::uint32_t t) {
    return (nearest_point(triangles[t], place).point - place).squaredNorm() >= reach * reach;
  };
  found.erase(std::remove_if(found.begin() + before, found.end(), far), found.end());
}

}  // namespace diefill::engine
