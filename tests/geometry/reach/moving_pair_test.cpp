// Solids that move past each other: what slides, what cuts.
#include "geometry/reach/moving_pair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

constexpr double kTolerance = 1e-4;

SolidPose at(double x, double y, double z) {
  SolidPose pose;
  pose.translation = {x, y, z};
  return pose;
}

class Blocks {
 public:
  Blocks(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper)
      : mesh_(sample::box({-0.02, -0.02, -0.01}, {0.02, 0.02, 0})),
        other_(sample::box(lower, upper)),
        solid_(mesh_),
        other_solid_(other_),
        pair_(other_, other_solid_, mesh_, solid_, kTolerance) {}
  std::optional<MovingPair::Cut> find_cut(const SolidPose& pose) { return pair_.find_cut(pose, {}); }

 private:
  Mesh mesh_, other_;
  SolidQuery solid_, other_solid_;
  MovingPair pair_;
};

TEST(MovingPair, SlidingOnAPlateIsNoCut) {
  Blocks blocks({-0.005, -0.005, 0}, {0.005, 0.005, 0.01});
  for (int n = 0; n <= 100; ++n) EXPECT_FALSE(blocks.find_cut(at(-0.03 + 6e-4 * n, 0, 0))) << n;
}

TEST(MovingPair, ALoweredBlockCutsFromTheToleranceOn) {
  Blocks blocks({-0.005, -0.005, 0}, {0.005, 0.005, 0.01});
  EXPECT_FALSE(blocks.find_cut(at(0, 0, 1e-3)));
  EXPECT_FALSE(blocks.find_cut(at(0, 0, -0.5 * kTolerance)));
  const auto cut = blocks.find_cut(at(0, 0, -2e-3));
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->depth, 2e-3, 1e-9);
  EXPECT_FALSE(blocks.find_cut(at(0, 0, 1e-3)));
}

TEST(MovingPair, FindsBarsThatCrossWithoutACornerInEachOther) {
  Blocks blocks({-0.05, -0.002, -0.002}, {0.05, 0.002, 0.002});
  EXPECT_FALSE(blocks.find_cut(at(0, 0, 0.0021)));
  const auto cut = blocks.find_cut(at(0, 0, -0.005));
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->depth, 0.005, 2.1e-3);
}

TEST(MovingPair, TurningCountsAsMoving) {
  // Clears the plate upright, and swings through it about its upper end.
  Blocks blocks({-0.002, -0.002, 0}, {0.002, 0.002, 0.04});
  SolidPose pose = at(0, 0, 0.001);
  EXPECT_FALSE(blocks.find_cut(pose));
  pose.rotation = Eigen::AngleAxisd(3.14159265358979, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_TRUE(blocks.find_cut(pose));
}

TEST(MovingPair, ASheetIsAsThickAsItIs) {
  EXPECT_NEAR(mean_thickness(sample::box({0, 0, 0}, {0.1, 0.1, 2.5e-4})), 2.5e-4, 2e-6);
}

}  // namespace
}  // namespace diefill::geometry
