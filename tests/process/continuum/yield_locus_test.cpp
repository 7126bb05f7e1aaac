// Yield loci and Mohr circles against their geometry.
#include "process/continuum/yield_locus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace diefill::process::continuum {
namespace {

constexpr YieldLocus kLocus{0.5, 400};

/// Pa, from the circle's centre to the line.
double distance(const YieldLocus& locus, const MohrCircle& circle) {
  return locus.at(circle.centre) / std::sqrt(1 + locus.slope * locus.slope);
}

TEST(YieldLocus, IsTheLineOfPointsOnIt) {
  std::vector<StressPoint> points;
  for (const double normal : {2000.0, 1750.0, 1500.0, 1250.0, 1000.0})
    points.push_back({normal, kLocus.at(normal)});
  const YieldLocus found = yield_locus_through(points);
  EXPECT_NEAR(found.slope, 0.5, 1e-12);
  EXPECT_NEAR(found.cohesion, 400, 1e-9);
  // One point above its neighbours by e moves the mean by e / 5, and nothing else in the middle.
  points[2].shear += 50;
  EXPECT_NEAR(yield_locus_through(points).slope, 0.5, 1e-12);
  EXPECT_NEAR(yield_locus_through(points).cohesion, 410, 1e-9);
}

TEST(YieldLocus, OfOneNormalStressIsNone) {
  EXPECT_TRUE(std::isnan(yield_locus_through({}).slope));
  EXPECT_TRUE(std::isnan(yield_locus_through({{1e3, 2}, {1e3, 4}}).slope));
}

TEST(MohrCircles, TouchTheLocus) {
  const MohrCircle unconfined = unconfined_circle(kLocus);
  EXPECT_NEAR(distance(kLocus, unconfined), unconfined.radius, 1e-9);
  EXPECT_NEAR(unconfined.minor(), 0, 1e-12);
  const StressPoint preshear{3e3, 1.7e3};
  const MohrCircle steady = steady_circle(kLocus, preshear);
  EXPECT_NEAR(distance(kLocus, steady), steady.radius, 1e-9);
  EXPECT_NEAR(std::hypot(preshear.normal - steady.centre, preshear.shear), steady.radius, 1e-9);
  // It touches on the left of the pre-shear point.
  EXPECT_LT(steady.centre - steady.radius * std::sin(std::atan(kLocus.slope)), preshear.normal);
  EXPECT_NEAR(flow_function(kLocus, preshear), steady.major() / unconfined.major(), 1e-12);
}

TEST(MohrCircles, OfAPreShearPointAboveTheLocusTouchThere) {
  const MohrCircle circle = steady_circle(kLocus, {3e3, 2.5e3});
  EXPECT_NEAR(distance(kLocus, circle), circle.radius, 1e-9);
  EXPECT_NEAR(circle.centre - circle.radius * std::sin(std::atan(kLocus.slope)), 3e3, 1e-9);
}

TEST(MohrCircles, WithoutCohesionHaveTheAngleOfTheLocus) {
  const YieldLocus free{0.5, 0};
  const MohrCircle circle = steady_circle(free, {3e3, 1.5e3});
  EXPECT_NEAR(effective_angle(circle), std::atan(0.5) * 180 / std::numbers::pi, 1e-6);
  EXPECT_TRUE(std::isnan(flow_function(free, {3e3, 1.5e3})));
}

}  // namespace
}  // namespace diefill::process::continuum
