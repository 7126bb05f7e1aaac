// The voxels that moving and standing solids block, pose after pose.
#pragma once

#include "geometry/reach/reach.h"
#include "geometry/reach/solid_rows.h"
#include "geometry/reach/voxel_grid.h"

namespace diefill::geometry {

/// Where a solid is: x_laboratory = rotation x_body + translation (m).
struct SolidPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d to_laboratory(const Eigen::Vector3d& body) const { return rotation * body + translation; }
  Eigen::Vector3d to_body(const Eigen::Vector3d& point) const {
    return rotation.transpose() * (point - translation);
  }
};

/// Voxelises solids; those that never move only once.
class PosedSolids {
 public:
  PosedSolids(const std::vector<MovingSolid>& solids, const VoxelGrid& grid);

  /// Number of samples, at least 1.
  std::size_t samples() const { return samples_; }
  bool stands(std::size_t solid) const { return stands_[solid]; }
  SolidPose pose(std::size_t solid, std::size_t sample) const;
  /// Poses between two samples, so close that no point of the solid moves farther than a voxel from one to
  /// the next; the first is that of `sample`, the last that of the next.
  std::vector<SolidPose> poses_to_next(std::size_t solid, std::size_t sample) const;
  /// One byte a voxel: 1 where solids or gaps between them narrower than a voxel are.
  std::vector<std::uint8_t> blocked(std::size_t sample);
  /// A part of the grid round a single solid, and what the solid blocks there.
  struct Part {
    Eigen::Vector3i first = Eigen::Vector3i::Zero();  ///< voxel of the whole grid where the part begins
    VoxelGrid grid;
    std::vector<std::uint8_t> blocked;
  };
  Part blocked_by(std::size_t solid, const SolidPose& pose);

 private:
  std::vector<SolidRows> rows_of(std::size_t solid, const SolidPose& pose);

  const std::vector<MovingSolid>& solids_;
  const VoxelGrid& grid_;
  LineCrossings crossings_;
  std::size_t samples_ = 1;
  std::vector<bool> stands_;
  std::vector<std::vector<SolidRows>> standing_;  // by axis
  std::vector<std::uint8_t> standing_blocked_;
};

}  // namespace diefill::geometry
