#include "geometry/reach/voxel_grid.h"

#include <cstdio>

namespace diefill::geometry {
namespace {

constexpr double kMaxVoxels = 2e8;  // a flood of them takes some two gigabytes

}  // namespace

VoxelGrid VoxelGrid::over(const Box& box, double edge) {
  const Eigen::Vector3d voxels = box.size() / edge;
  if (!(voxels.cwiseMax(1).prod() <= kMaxVoxels)) {
    char text[280];
    std::snprintf(text, sizeof text,
                  "the volume of %.4g x %.4g x %.4g mm occupied by tools and powder is too large to search "
                  "in steps of %.3g mm; check whether a position or a motion has the wrong unit",
                  1e3 * box.size()[0], 1e3 * box.size()[1], 1e3 * box.size()[2], 1e3 * edge);
    throw MeshError(text);
  }
  return {box.lower, edge, (voxels.array() - 1e-9).ceil().max(1).cast<int>().matrix()};
}

std::size_t VoxelGrid::size() const {
  return static_cast<std::size_t>(counts.x()) * static_cast<std::size_t>(counts.y()) *
         static_cast<std::size_t>(counts.z());
}

Eigen::Vector3i VoxelGrid::voxel_at(const Eigen::Vector3d& point) const {
  // Far points would overflow an int: anything beyond the grid is as good as just beyond it.
  const Eigen::Array3d voxel = ((point - origin) / edge).array().floor();
  return voxel.max(-1.0).min(counts.cast<double>().array()).cast<int>().matrix();
}

}  // namespace diefill::geometry
