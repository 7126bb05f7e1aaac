// Symmetry of a solid and the space between two, against shapes of which both are known.
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/solid/gaps.h"
#include "geometry/solid/symmetry.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/geometry/sample_tool_files.h"

namespace diefill::geometry {
namespace {

Mesh turned(const Mesh& mesh, double degrees) {
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Eigen::Vector3d::UnitZ());
  return transformed(mesh, turn.toRotationMatrix(), {1e-3, 2e-3, 3e-3});
}

TEST(FindSymmetry, OfABoxThatStandsAskew) {
  const Mesh box = sample::box({0, 0, 0}, {0.01, 0.02, 0.03});
  const Symmetry straight = find_symmetry(SolidQuery(box), 1e-6);
  EXPECT_EQ(straight.planes.size(), 3U);
  ASSERT_EQ(straight.axes.size(), 3U);
  for (const auto& axis : straight.axes) EXPECT_EQ(axis.order, 2);
  EXPECT_LT((straight.centre - Eigen::Vector3d(0.005, 0.01, 0.015)).norm(), 1e-12);
  EXPECT_EQ(straight.description(),
            "mirror planes across x, y and z; 2-fold about x; 2-fold about y; 2-fold about z, through (5.00, "
            "10.00, 15.00) mm");
  const Symmetry askew = find_symmetry(SolidQuery(turned(box, 20)), 1e-6);
  EXPECT_EQ(askew.planes.size(), 3U);
  EXPECT_EQ(askew.axes.size(), 3U);
}

TEST(FindSymmetry, TellsAPolygonFromACircle) {
  const Mesh hexagon = sample::cylinder(8e-3, 5e-3, 6);
  const Symmetry six = find_symmetry(SolidQuery(hexagon), 1e-6);
  EXPECT_NE(six.description().find("6-fold about z"), std::string::npos) << six.description();
  const Symmetry round = find_symmetry(SolidQuery(sample::cylinder(8e-3, 5e-3, 500)), 1e-6);
  EXPECT_NE(round.description().find("axisymmetric about z"), std::string::npos) << round.description();
}

TEST(FindSymmetry, CountsThePolygonThatStandsForACircle) {
  // Within 0.05 mm it is round at some angles and not at others.
  const Symmetry symmetry = find_symmetry(SolidQuery(sample::tube(18e-3, 22e-3, 40e-3, 48)), 3e-5);
  EXPECT_EQ(
      symmetry.description(),
      "mirror planes across x, y and z; 2-fold about x; 2-fold about y; 48-fold about z, through (0.00, "
      "0.00, 20.00) mm");
}

TEST(FindSymmetry, SeesHolesThatPierceAGear) {
  for (const char* file : {"gear/core_rods.stl", "gear/punch.stl"}) {  // 20 teeth, but four holes
    const Symmetry symmetry = find_symmetry(SolidQuery(sample::tool(file)), 3e-5);
    EXPECT_NE(symmetry.description().find("4-fold about z"), std::string::npos) << symmetry.description();
  }
}

TEST(FindSymmetry, OfSomethingWithout) {
  Mesh mesh = sample::box({0, 0, 0}, {0.01, 0.02, 0.03});
  mesh.vertices[7] += Eigen::Vector3d(1e-3, 2e-3, -1e-3);
  EXPECT_EQ(find_symmetry(SolidQuery(mesh), 1e-6).description(), "none found");
}

TEST(MeasureGap, BetweenAPunchAndItsBore) {
  const Mesh bore = sample::tube(10e-3, 20e-3, 20e-3, 256), punch = sample::cylinder(9.98e-3, 10e-3, 256);
  const Gap gap = measure_gap(SolidQuery(punch), SolidQuery(bore), 1e-3, 5e-4, {});
  ASSERT_TRUE(gap.found);
  EXPECT_NEAR(gap.widest, 2e-5, 1e-6);
  EXPECT_NEAR(gap.narrowest, 2e-5, 1e-6);
}

TEST(MeasureGap, FindsTheWidePlaceOfAPunchOffCentre) {
  const Mesh bore = sample::tube(10e-3, 20e-3, 20e-3, 256);
  const Mesh punch = transformed(sample::cylinder(9.8e-3, 10e-3, 256), Eigen::Matrix3d::Identity(),
                                 Eigen::Vector3d(0.15e-3, 0, 5e-3));
  const Gap gap = measure_gap(SolidQuery(punch), SolidQuery(bore), 1e-3, 2e-4, {});
  ASSERT_TRUE(gap.found);
  EXPECT_NEAR(gap.narrowest, 0.05e-3, 2e-6);
  EXPECT_NEAR(gap.widest, 0.35e-3, 2e-6);
  EXPECT_LT(gap.widest_place.x(), -9e-3);
}

TEST(MeasureGap, OverlapsCountAsNoneAndCavitiesArePassedOver) {
  const Mesh bore = sample::tube(10e-3, 20e-3, 20e-3, 256), rubbing = sample::cylinder(10.02e-3, 20e-3, 256);
  const Gap gap = measure_gap(SolidQuery(rubbing), SolidQuery(bore), 1e-3, 5e-4, {});
  ASSERT_TRUE(gap.found);
  EXPECT_EQ(gap.widest, 0);
  const auto everywhere = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return true; };
  EXPECT_FALSE(measure_gap(SolidQuery(rubbing), SolidQuery(bore), 1e-3, 5e-4, everywhere).found);
  const Mesh far = sample::box({0.1, 0, 0}, {0.2, 0.1, 0.1});
  EXPECT_FALSE(measure_gap(SolidQuery(far), SolidQuery(bore), 1e-3, 5e-4, {}).found);
}

}  // namespace
}  // namespace diefill::geometry
