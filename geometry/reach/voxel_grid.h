// A grid of cubic voxels.
#pragma once

#include <cstddef>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// Voxels (i, j, k) along x, y, z; the lower corner of (0, 0, 0) is `origin`.
struct VoxelGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m
  double edge = 0;                                   ///< m
  Eigen::Vector3i counts = Eigen::Vector3i::Zero();

  /// The smallest grid of this edge over `box`, flush with the box's lower corner. Throws MeshError for too
  /// many voxels.
  static VoxelGrid over(const Box& box, double edge);

  std::size_t size() const;
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(counts.y()) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(counts.x()) +
           static_cast<std::size_t>(i);
  }
  bool has(const Eigen::Vector3i& voxel) const {
    return (voxel.array() >= 0).all() && (voxel.array() < counts.array()).all();
  }
  /// The voxel a point (m) lies in; it may lie outside the grid.
  Eigen::Vector3i voxel_at(const Eigen::Vector3d& point) const;
  /// m.
  Eigen::Vector3d centre(const Eigen::Vector3i& voxel) const {
    return origin + (voxel.cast<double>().array() + 0.5).matrix() * edge;
  }
};

}  // namespace diefill::geometry
