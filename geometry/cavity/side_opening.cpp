#include "geometry/cavity/side_opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/cavity/cavity_region.h"
#include "geometry/reach/solid_rows.h"

namespace diefill::geometry {
namespace {

constexpr double kVoxels = 2e6;
constexpr double kFinestVoxel = 5e-5;    // m
constexpr double kSmallestShare = 1e-3;  // of the box, of a space that counts

/// Over `space`, a voxel beyond it on all sides but the top; lines of centres shifted as in cavity.cpp.
VoxelGrid grid_over(const Box& space) {
  VoxelGrid grid;
  grid.edge = std::max(kFinestVoxel, std::cbrt(space.size().prod() / kVoxels));
  grid.counts = ((space.size() / grid.edge).array().ceil() + 3).cast<int>().matrix();
  grid.origin = space.lower - grid.edge * Eigen::Vector3d(1.37, 1.29, 0);
  grid.origin.z() = space.upper.z() - grid.edge * grid.counts.z();
  return grid;
}

/// Priority flood of the free space (Barnes, Lehman and Mulla 2014): every voxel with the lowest layer to
/// which a fill from all round the solids has to rise before it reaches the voxel.
class PriorityFlood {
 public:
  PriorityFlood(const VoxelGrid& grid, const std::vector<std::uint8_t>& blocked)
      : grid_(grid),
        blocked_(blocked),
        level_(grid.size(), kUnreached),
        from_(grid.size()),
        front_(static_cast<std::size_t>(grid.counts.z())) {
    for (int k = 0; k < grid.counts.z(); ++k)
      for (int j = 0; j < grid.counts.y(); ++j)
        for (int i = 0; i < grid.counts.x(); ++i)
          if (k == 0 || at_side({i, j, k})) reach({i, j, k}, k, {i, j, k});
    for (std::size_t level = 0; level < front_.size(); ++level)
      for (std::size_t next = 0; next < front_[level].size(); ++next)
        spread(front_[level][next], static_cast<int>(level));
  }

  /// Voxels below the layer over which the fill reaches them, by that layer.
  std::vector<std::vector<Eigen::Vector3i>> depressions() const {
    std::vector<std::vector<Eigen::Vector3i>> depressions(front_.size());
    for (const auto& reached : front_)
      for (const Eigen::Vector3i& voxel : reached) {
        const int level = level_[at(voxel)];
        if (level > voxel.z()) depressions[static_cast<std::size_t>(level)].push_back(voxel);
      }
    return depressions;
  }

  /// The way by which the fill came to a voxel, from it outwards.
  std::vector<Eigen::Vector3i> way_out(Eigen::Vector3i voxel) const {
    std::vector<Eigen::Vector3i> way = {voxel};
    while (from_[at(voxel)] != voxel) way.push_back(voxel = from_[at(voxel)]);
    return way;
  }

 private:
  static constexpr int kUnreached = -1;

  std::size_t at(const Eigen::Vector3i& voxel) const { return grid_.index(voxel.x(), voxel.y(), voxel.z()); }

  bool at_side(const Eigen::Vector3i& voxel) const {
    return voxel.x() == 0 || voxel.y() == 0 || voxel.x() == grid_.counts.x() - 1 ||
           voxel.y() == grid_.counts.y() - 1;
  }

  void reach(const Eigen::Vector3i& voxel, int level, const Eigen::Vector3i& from) {
    if (blocked_[at(voxel)] != 0 || level_[at(voxel)] != kUnreached) return;
    level_[at(voxel)] = level;
    from_[at(voxel)] = from;
    front_[static_cast<std::size_t>(level)].push_back(voxel);
  }

  void spread(Eigen::Vector3i voxel, int level) {  // a copy: the list that it is from grows
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Eigen::Vector3i next = voxel;
        next[axis] += step;
        if (grid_.has(next)) reach(next, std::max(level, next.z()), voxel);
      }
  }

  const VoxelGrid& grid_;
  const std::vector<std::uint8_t>& blocked_;
  std::vector<int> level_;             ///< layer to which the fill has risen when it reaches the voxel
  std::vector<Eigen::Vector3i> from_;  ///< the voxel that it came from
  std::vector<std::vector<Eigen::Vector3i>> front_;  ///< voxels by that layer
};

/// m, the top of the solids that end just below the middle of a voxel; minus infinity where none does.
double floor_below(const VoxelGrid& grid, const Eigen::Vector3i& voxel,
                   const std::vector<const Mesh*>& solids) {
  VoxelGrid column = grid;
  column.origin.head<2>() += grid.edge * voxel.head<2>().cast<double>();
  column.counts.head<2>().setOnes();
  const double middle = grid.centre(voxel).z();
  double floor = -std::numeric_limits<double>::infinity();
  LineCrossings crossings;
  for (const Mesh* solid : solids) {
    const SolidRows rows(*solid, column, 2, crossings);
    for (const auto& row : rows.rows())
      if (row.span.end <= middle && row.span.end > middle - 1.5 * grid.edge)
        floor = std::max(floor, row.span.end);
  }
  return floor;
}

SideOpening opening_of(const VoxelGrid& grid, const std::vector<Eigen::Vector3i>& way, int level,
                       const Box& space, const std::vector<const Mesh*>& solids) {
  SideOpening opening;
  opening.height = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3i& voxel : way) {
    const Eigen::Vector3d centre = grid.centre(voxel);
    const bool within =
        (centre.array() >= space.lower.array()).all() && (centre.array() <= space.upper.array()).all();
    if (!within || voxel.z() != level) continue;
    opening.height = std::max(opening.height, floor_below(grid, voxel, solids));
    opening.place = centre;
  }
  return opening;
}

}  // namespace

std::optional<SideOpening> find_side_opening(const std::vector<const Mesh*>& solids, double fill_plane) {
  Box space;
  for (const Mesh* solid : solids) space.include(solid->bounding_box());
  space.upper.z() = fill_plane;
  if (solids.empty() || space.size().minCoeff() <= 0) return std::nullopt;
  const VoxelGrid grid = grid_over(space);
  auto blocked = blocked_voxels(grid, solids, kLargestFit);
  close_short_stretches(grid, kLargestFit, blocked);
  const PriorityFlood flood(grid, blocked);
  const auto depressions = flood.depressions();
  const auto largest =
      std::max_element(depressions.begin(), depressions.end(),
                       [](const auto& one, const auto& other) { return one.size() < other.size(); });
  const double volume = static_cast<double>(largest->size()) * std::pow(grid.edge, 3);
  if (volume < kSmallestShare * space.size().prod()) return std::nullopt;
  const auto level = static_cast<int>(largest - depressions.begin());
  SideOpening opening = opening_of(grid, flood.way_out(largest->front()), level, space, solids);
  if (!std::isfinite(opening.height)) opening.height = grid.origin.z() + level * grid.edge;
  opening.volume = volume;
  return opening;
}

}  // namespace diefill::geometry
