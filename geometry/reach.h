// Where powder can get to: free space joined to the poured powder, found by flooding a voxel grid downwards and
// sideways around the tools in all the poses they take. Only surfaces next to that space need wall spheres.
#pragma once

#include <memory>
#include <vector>

#include "geometry/mesh.h"

namespace diefill::geometry {

/// A solid and the translations (m) and rotations it goes through, sampled densely enough that steps are below a voxel
/// or that nothing is gained from the poses between.
struct MovingSolid {
  const Mesh* mesh = nullptr;
  std::vector<Eigen::Matrix3d> rotations;        ///< one a sample; all solids have the same number of samples
  std::vector<Eigen::Vector3d> translations;     ///< m, one a sample
};

/// What to flood.
struct ReachRequest {
  std::vector<MovingSolid> solids;
  Box powder;              ///< m, where the poured powder starts (laboratory frame)
  double climb = 0;        ///< m, how far powder may rise above where it stands (a heap pushed by the shoe)
  double voxel = 5e-4;     ///< m, edge of a voxel; openings narrower than this are taken as closed
  Box domain;              ///< m, powder leaving this box is gone
};

/// Answers which surface points powder can touch, per solid, in the solid's own frame.
class Reach {
 public:
  explicit Reach(const ReachRequest& request);
  /// True if powder can come within `margin` (m) of this surface point of solid `solid` in one of the sampled poses.
  bool reachable(std::size_t solid, const Eigen::Vector3d& point_in_body, const Eigen::Vector3d& outward_normal,
                 double margin) const;
  /// Volume (m^3) of reachable space below height `z` (m) inside the horizontal extent of `box`, first sample.
  double volume_below(double z, const Box& box) const;

 private:
  struct Sample;
  std::vector<std::shared_ptr<const Sample>> samples_;
  ReachRequest request_;
};

}  // namespace diefill::geometry
