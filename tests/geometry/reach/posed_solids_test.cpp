// What solids block on their way, in the grid and beyond it.
#include "geometry/reach/posed_solids.h"

#include <gtest/gtest.h>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

// A shoe that comes from metres away blocks nothing until it is there.
TEST(PosedSolids, BlockNothingOutsideTheGrid) {
  const Mesh cube = sample::box({-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01});
  const VoxelGrid grid = VoxelGrid::over({{-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}}, 1e-3);
  const std::vector<MovingSolid> solids = {{&cube, {Eigen::Matrix3d::Identity()}, {Eigen::Vector3d::Zero()}}};
  PosedSolids posed(solids, grid);
  SolidPose pose;
  EXPECT_FALSE(posed.blocked_by(0, pose).blocked.empty());
  for (const double away : {-10.0, -0.031, 0.031, 10.0}) {
    pose.translation = {away, 0, 0};
    EXPECT_TRUE(posed.blocked_by(0, pose).blocked.empty()) << away;
  }
}

}  // namespace
}  // namespace diefill::geometry
