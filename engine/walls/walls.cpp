#include "engine/walls/walls.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace diefill::engine {

namespace {

/// Cells of a body are limited to this number; larger cells then make up for it.
constexpr double kMaxCells = 1.6e7;
/// m, extent of a body that has no end: any turn moves its far parts far.
constexpr double kEndless = 1e6;

}  // namespace

WallBody::WallBody(WallBodySpec spec, double reach) : spec_(std::move(spec)), reach_(reach) {
  if (flat() + meshed() + !spec_.centres.empty() > 1)
    throw std::invalid_argument("a wall is made of spheres, planes or triangles, not of more than one kind");
  if (flat()) {
    extent_ = kEndless;
    lower_ = Eigen::Vector3d::Constant(-kEndless);
    upper_ = Eigen::Vector3d::Constant(kEndless);
    return;
  }
  lower_ = Eigen::Vector3d::Constant(1e300);
  upper_ = Eigen::Vector3d::Constant(-1e300);
  for (const auto& centre : spec_.centres) include(centre);
  take_in_triangles();
  if (spec_.centres.empty()) return;
  cell_size_ = reach;
  const Eigen::Vector3d size = upper_ - lower_ + Eigen::Vector3d::Constant(4 * reach);
  while (size.prod() / (cell_size_ * cell_size_ * cell_size_) > kMaxCells) cell_size_ *= 1.2;
  // One empty cell all round, so that neighbours of a cell with spheres always exist.
  for (int axis = 0; axis < 3; ++axis)
    cells_[axis] = static_cast<int>(std::floor((upper_[axis] - lower_[axis]) / cell_size_)) + 3;
  sort_into_cells();
  mark_neighbourhoods();
}

void WallBody::include(const Eigen::Vector3d& point) {
  lower_ = lower_.cwiseMin(point);
  upper_ = upper_.cwiseMax(point);
  extent_ = std::max(extent_, point.norm());
}

void WallBody::take_in_triangles() {
  for (const auto& triangle : spec_.triangles) {
    for (const auto& corner : triangle.corner) include(corner);
    normals_.push_back(triangle.normal());
    if (!(std::abs(normals_.back().norm() - 1) < 1e-6))
      throw std::invalid_argument("a triangle of wall \"" + name() + "\" has no area, so it has no normal");
  }
  triangle_cells_ = TriangleCells(spec_.triangles, reach_);
}

Eigen::Vector3i WallBody::cell_of(const Eigen::Vector3d& body_point) const {
  return ((body_point - lower_) / cell_size_).array().floor().cast<int>() + 1;
}

std::size_t WallBody::index_of(const Eigen::Vector3i& cell) const {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(cells_[1]) +
          static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(cells_[0]) +
         static_cast<std::size_t>(cell[0]);
}

void WallBody::sort_into_cells() {
  const std::size_t count = spec_.centres.size();
  std::vector<std::size_t> cell(count);
  for (std::size_t w = 0; w < count; ++w) cell[w] = index_of(cell_of(spec_.centres[w]));
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return cell[a] < cell[b]; });

  std::vector<Eigen::Vector3d> sorted(count);
  for (std::size_t w = 0; w < count; ++w) sorted[w] = spec_.centres[order[w]];
  spec_.centres.swap(sorted);
  first_.assign(static_cast<std::size_t>(cells_.cast<double>().prod()) + 1, 0);
  for (std::size_t w = 0; w < count; ++w) ++first_[cell[w] + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

void WallBody::mark_neighbourhoods() {
  neighbourhood_.assign(first_.size() - 1, 0);
  for (int z = 1; z + 1 < cells_[2]; ++z)
    for (int y = 1; y + 1 < cells_[1]; ++y)
      for (int x = 1; x + 1 < cells_[0]; ++x) {
        const std::size_t here = index_of({x, y, z});
        if (first_[here] == first_[here + 1]) continue;
        for (int dz = -1; dz <= 1; ++dz)
          for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) neighbourhood_[index_of({x + dx, y + dy, z + dz})] = 1;
      }
}

void WallBody::find(const Eigen::Vector3d& body_point, double reach,
                    std::vector<std::uint32_t>& found) const {
  for (std::uint32_t k = 0; k < spec_.planes.size(); ++k)
    if (spec_.planes[k].normal.dot(body_point - spec_.planes[k].point) < reach) found.push_back(k);
  if (spec_.centres.empty() && !meshed()) return;
  const Eigen::Vector3d beyond = (lower_ - body_point).cwiseMax(body_point - upper_);
  if (beyond.maxCoeff() > reach) return;
  if (meshed()) return triangle_cells_.find(spec_.triangles, body_point, reach, found);
  const Eigen::Vector3i cell = cell_of(body_point);
  if ((cell.array() < 0).any() || (cell.array() >= cells_.array()).any()) return;
  if (!neighbourhood_[index_of(cell)]) return;
  // A short reach meets fewer cells than the neighbours that the longest needs.
  const Eigen::Vector3d to = Eigen::Vector3d::Constant(reach);
  const Eigen::Vector3i low = cell_of(body_point - to).array().max(0);
  const Eigen::Vector3i high = cell_of(body_point + to).array().min(cells_.array() - 1);
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y) {
      // Cells along x lie together: one run of wall spheres for all three.
      const std::uint32_t begin = first_[index_of({low[0], y, z})];
      const std::uint32_t end = first_[index_of({high[0], y, z}) + 1];
      for (std::uint32_t w = begin; w < end; ++w)
        if ((spec_.centres[w] - body_point).squaredNorm() < reach * reach) found.push_back(w);
    }
}

}  // namespace diefill::engine
