// Mass, centre and moments of inertia of unions of spheres, against closed forms.
#include "engine/powder/clump_union.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace diefill::engine {
namespace {

constexpr double kDensity = 7800, kRadius = 1e-4;

double ball(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

TEST(ClumpUnion, OfOneSphereIsTheSphere) {
  const GrainShape grain = grain_of_union({{{3e-4, 0, 1e-4}, kRadius}}, kDensity);
  const double mass = kDensity * ball(kRadius);
  EXPECT_NEAR(grain.mass, mass, 1e-4 * mass);
  EXPECT_NEAR(grain.inertia.x(), 0.4 * mass * kRadius * kRadius, 2e-4 * 0.4 * mass * kRadius * kRadius);
  EXPECT_LT(grain.sphere_offsets.front().norm(), 1e-6 * kRadius);
}

TEST(ClumpUnion, OfSpheresApartIsTheirSum) {
  const double small = 0.5 * kRadius, apart = 4 * kRadius;
  const GrainShape grain = grain_of_union({{{0, 0, 0}, kRadius}, {{apart, 0, 0}, small}}, kDensity);
  const double heavy = kDensity * ball(kRadius), light = kDensity * ball(small), mass = heavy + light;
  EXPECT_NEAR(grain.mass, mass, 2e-4 * mass);
  const double about_axis = 0.4 * (heavy * kRadius * kRadius + light * small * small);
  const double across = about_axis + heavy * light / mass * apart * apart;
  EXPECT_NEAR(grain.inertia.minCoeff(), about_axis, 1e-3 * about_axis);
  EXPECT_NEAR(grain.inertia.maxCoeff(), across, 5e-4 * across);
  EXPECT_NEAR((grain.sphere_offsets[0] - grain.sphere_offsets[1]).norm(), apart, 1e-12);
  EXPECT_EQ(grain.radius_of(1), small);
  EXPECT_EQ(grain.sphere_radius, small);
}

TEST(ClumpUnion, CountsAnOverlapOnce) {
  // Two spheres at the distance of their radius: the lens is 5/16 of a sphere.
  const GrainShape grain = grain_of_union({{{0, 0, 0}, kRadius}, {{0, kRadius, 0}, kRadius}}, kDensity);
  EXPECT_NEAR(grain.solid_volume, (2 - 5.0 / 16) * ball(kRadius), 1e-3 * ball(kRadius));
  EXPECT_TRUE(grain.sphere_radii.empty()) << "equal spheres";
  const GrainShape twice = grain_of_union({{{0, 0, 0}, kRadius}, {{0, 0, 0}, kRadius}}, kDensity);
  EXPECT_NEAR(twice.solid_volume, ball(kRadius), 1e-4 * ball(kRadius));
}

TEST(ClumpUnion, RefusesNonsense) {
  EXPECT_THROW(grain_of_union({}, kDensity), std::invalid_argument);
  EXPECT_THROW(grain_of_union({{{0, 0, 0}, 0}}, kDensity), std::invalid_argument);
  EXPECT_THROW(grain_of_union({{{0, 0, 0}, kRadius}}, -1), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
