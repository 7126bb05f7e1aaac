// Floods free voxels with powder: down and sideways without limit, upwards only as far as a heap may rise.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/reach/voxel_grid.h"

namespace diefill::geometry {

/// Voxels that powder has got to. Each keeps the height up to which powder there may rise: `climb` above the
/// lowest place on the highest way to it. Where powder rises above that way it loses 3/4 of a voxel in height
/// for every voxel it goes sideways, as a heap with an angle of repose of 37 degrees does (Bierwisch 2009,
/// section 4.1.4); where powder `scatters` it loses none.
class ReachFlood {
 public:
  ReachFlood(const VoxelGrid& grid, double climb, bool scatters);

  /// Powder appears in the free voxels of `boxes` and spreads. It stays below the top of what holds it: the
  /// highest layer in which walls keep that of any box from running sideways to the border of the grid.
  /// Powder above that layer only falls.
  void pour(const std::vector<Box>& boxes, const std::vector<std::uint8_t>& blocked);

  /// Removes powder from blocked voxels and lets the rest spread.
  void spread(const std::vector<std::uint8_t>& blocked);

  /// Moves powder from one voxel to another. Lifted powder lifts what stands on it: the column grows at its
  /// top.
  void move(const Eigen::Vector3i& from, const Eigen::Vector3i& to);
  void remove(const Eigen::Vector3i& voxel) { head(voxel) = kNone; }

  bool reached(const Eigen::Vector3i& voxel) const {
    return heads_[grid_.index(voxel.x(), voxel.y(), voxel.z())] != kNone;
  }
  /// One byte a voxel: 1 where powder is.
  std::vector<std::uint8_t> reached_voxels() const;
  const VoxelGrid& grid() const { return grid_; }

 private:
  // Heights in quarters of a voxel, so that losing 3/4 is exact.
  static constexpr std::int32_t kNone = -1, kVoxel = 4, kLossOfHeap = 3;

  std::int32_t& head(const Eigen::Vector3i& voxel) {
    return heads_[grid_.index(voxel.x(), voxel.y(), voxel.z())];
  }
  std::int32_t highest_head(int layer) const { return kVoxel * layer + climb_; }
  static std::int32_t climb_in(const VoxelGrid& grid, double climb, bool scatters);
  void place(const Box& box);
  void drop_falling();
  int holding_layer(const Box& box, const std::vector<std::uint8_t>& blocked) const;
  template <typename Visit>
  void for_ways_on(const Eigen::Vector3i& voxel, Visit visit) const;
  bool would_enter(const Eigen::Vector3i& voxel, std::int32_t new_head,
                   const std::vector<std::uint8_t>& blocked) const;

  VoxelGrid grid_;
  std::int32_t climb_;
  std::int32_t loss_;  // of what has risen, for every voxel sideways
  int ceiling_;        // layer above which powder only falls
  std::vector<std::int32_t> heads_;
  std::vector<std::vector<Eigen::Vector3i>> waiting_;  // by head
};

}  // namespace diefill::geometry
