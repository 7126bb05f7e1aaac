// Where powder can get to: free space joined to the poured powder, found by flooding a voxel grid downwards
// and sideways around the tools in all the poses they take. Only surfaces next to that space need wall
// spheres.
//
// Errors are on the side of too many surfaces: powder stays wherever it has been unless a tool moves in, and
// a moving tool takes along the powder that it meets. Powder does not run over the rim of its container when
// it is poured.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/reach/voxel_grid.h"

namespace diefill::geometry {

/// A solid and the translations (m) and rotations it goes through. Between two samples it is taken to move
/// straight on and to push powder ahead, but powder spreads at the samples only: they have to be dense where
/// a tool uncovers something new, such as one for every millimetre of a shoe's path over a cavity.
struct MovingSolid {
  const Mesh* mesh = nullptr;
  std::vector<Eigen::Matrix3d> rotations;     ///< one a sample; all solids have the same number of samples
  std::vector<Eigen::Vector3d> translations;  ///< m, one a sample
};

/// What to flood.
struct ReachRequest {
  std::vector<MovingSolid> solids;
  std::vector<Box>
      powder;        ///< m, where powder starts or comes in (laboratory frame); may reach above the tools
  double climb = 0;  ///< m, how far powder may rise above where it stands (a heap pushed by the shoe); such a
                     ///< heap runs out sideways over 4/3 of its height
  bool scatters = false;  ///< tools throw powder up: powder that has risen spreads sideways without limit
  double voxel = 5e-4;    ///< m, edge of a voxel; openings narrower than this are taken as closed
  Box domain;             ///< m, powder leaving this box is gone
};

/// Answers which surface points powder can touch, per solid, in the solid's own frame.
class Reach {
 public:
  /// Needs the request only while it is built. Throws std::invalid_argument when solids have different
  /// numbers of poses.
  explicit Reach(const ReachRequest& request);
  /// True if powder can come within `margin` (m, at most eleven voxels) in front of this surface point of
  /// solid `solid` in one of the sampled poses. To the size of a voxel, in doubt true.
  bool reachable(std::size_t solid, const Eigen::Vector3d& point_in_body,
                 const Eigen::Vector3d& outward_normal, double margin) const;

 private:
  // Powder near one solid in any sample, in the solid's own frame, one byte a voxel.
  struct Surroundings {
    VoxelGrid grid;
    std::vector<std::uint8_t> reached;
    VoxelGrid blocks;  // of eight voxels each way: most questions end at empty ones
    std::vector<std::uint8_t> block_reached;

    void mark_blocks();
    bool any_block(const Eigen::Vector3i& lower, const Eigen::Vector3i& upper) const;
  };
  VoxelGrid laboratory_;
  std::vector<std::uint8_t> first_;  // powder in the first sample, one byte a voxel
  std::vector<Surroundings> surroundings_;
};

}  // namespace diefill::geometry
