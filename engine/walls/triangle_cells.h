// A tool's triangles in cells of its own frame: those near a grain are found without visiting all.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/walls/wall_triangle.h"

namespace diefill::engine {

/// A regular grid of cells, each with the triangles that pass through it. In double precision, unlike the
/// ray tracers' trees that do the same: a plane of many triangles is to be as flat as one.
class TriangleCells {
 public:
  TriangleCells() = default;
  /// `reach`: distance (m) at which triangles will be requested; the size of a cell unless that gives too
  /// many.
  TriangleCells(const std::vector<WallTriangle>& triangles, double reach);

  /// Appends to `found`, in rising order, the triangles no farther than `reach` (m) from `place` (m).
  /// `triangles`: those of the constructor.
  void find(const std::vector<WallTriangle>& triangles, const Eigen::Vector3d& place, double reach,
            std::vector<std::uint32_t>& found) const;

 private:
  Eigen::Vector3i cell_of(const Eigen::Vector3d& place) const;
  std::size_t index_of(int x, int y, int z) const;
  template <class Visit>
  void visit_cells(const WallTriangle& triangle, const Visit& visit) const;

  double cell_size_ = 0;
  Eigen::Vector3d lower_ = Eigen::Vector3d::Zero();
  Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
  std::vector<std::uint32_t> first_;  ///< first entry of a cell in triangle_
  std::vector<std::uint32_t> triangle_;
};

}  // namespace diefill::engine
