// How deep a surface reaches into a solid, also where none of its corners lies inside.
#include "geometry/solid/penetration.h"

#include <gtest/gtest.h>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

constexpr double kResolution = 1e-4;

Penetration of(const Mesh& part, const Mesh& other) {
  return deepest_penetration(part, SolidQuery(other), other.bounding_box(), kResolution);
}

TEST(Penetration, ARodThroughADiscHasNoCornerInsideButOverlaps) {
  const Mesh rod = sample::cylinder(0.002, 0.06, 40);
  const Mesh disc = transformed(sample::cylinder(0.02, 0.01, 60), Eigen::Matrix3d::Identity(), {0, 0, 0.02});
  const Penetration found = of(rod, disc);
  EXPECT_NEAR(found.depth, 0.005, kResolution);  // halfway through the disc
  EXPECT_NEAR(found.place.z(), 0.025, kResolution);
}

TEST(Penetration, APunchWiderThanItsBoreReachesIntoTheDie) {
  const Mesh die = sample::tube(0.005, 0.02, 0.01, 48);
  const Mesh punch =
      transformed(sample::cylinder(0.007, 0.03, 48), Eigen::Matrix3d::Identity(), {0, 0, -0.01});
  EXPECT_NEAR(of(punch, die).depth, 0.002, kResolution);
}

TEST(Penetration, CornersAreMeasuredExactly) {
  const Mesh lower = sample::box({0, 0, 0}, {0.01, 0.01, 0.01});
  const Mesh upper = sample::box({0.002, 0.002, 0.009999}, {0.008, 0.008, 0.02});
  EXPECT_NEAR(of(upper, lower).depth, 1e-6, 1e-15);
}

TEST(Penetration, FlushAndDistantPartsDoNotOverlap) {
  const Mesh lower = sample::box({0, 0, 0}, {0.01, 0.01, 0.01});
  EXPECT_EQ(of(sample::box({0, 0, 0.01}, {0.01, 0.01, 0.02}), lower).depth, 0);
  EXPECT_EQ(of(sample::box({0, 0, 0.03}, {0.01, 0.01, 0.04}), lower).depth, 0);
}

}  // namespace
}  // namespace diefill::geometry
