// What is read off beds, heaps and mixers of spheres, against spheres placed by hand.
#include "process/laboratory/published/bed_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/laboratory/published/hu/heap_projection.h"
#include "process/laboratory/published/hu/inserted_bed.h"
#include "process/laboratory/published/hu/speed_density.h"

namespace diefill::process::laboratory {
namespace {

/// Single spheres of 2 mm of 1 g at these places, at rest.
results::PowderState spheres(const std::vector<Eigen::Vector3d>& places) {
  results::PowderState powder;
  powder.grain_diameter = 2e-3;
  powder.sphere_radius = 1e-3;
  powder.grain_mass = 1e-3;
  powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  powder.position = places;
  powder.velocity.assign(places.size(), Eigen::Vector3d::Zero());
  return powder;
}

TEST(BedWindow, ContactsAreCountedAcrossPeriodsAndForCentresInTheWindow) {
  auto bed = spheres({{-3.999e-3, 0, 5e-3}, {3.999e-3, 0, 5e-3}, {0, 0, 5e-3}, {0, 0, 6.99e-3}});
  bed.period = {9.99e-3, 9.99e-3, 0};  // 1.992 mm from image to image
  EXPECT_NEAR(contacts_between(bed, 4e-3, 6e-3), 1, 1e-12);
  EXPECT_NEAR(contacts_between(bed, 4e-3, 8e-3), 1, 1e-12);
  EXPECT_TRUE(std::isnan(contacts_between(bed, 8e-3, 9e-3)));
}

TEST(BedWindow, ContactsOfUnequalSpheresAreThoseThatOverlap) {
  auto bed = spheres({{0, 0, 5e-3}, {2.9e-3, 0, 5e-3}, {-1.9e-3, 0, 5e-3}});
  bed.kinds.diameter = {2e-3, 4e-3};
  bed.kinds.sphere_radius = {1e-3, 2e-3};
  bed.kind = {0, 1, 0};
  EXPECT_NEAR(contacts_between(bed, 0, 1e-2), 4.0 / 3, 1e-12);
}

TEST(BedWindow, SharesOfTheSmallestAreByMassInEverySlice) {
  auto bed = spheres({{0, 0, 1e-3}, {0, 0, 2e-3}, {0, 0, 7e-3}});
  bed.kinds.diameter = {2e-3, 4e-3};
  bed.kinds.mass = {1e-3, 8e-3};
  bed.kind = {0, 1, 0};
  const auto shares = small_share_by_slice(bed, 0, 0.01, 2);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_NEAR(shares[0], 1.0 / 9, 1e-12);
  EXPECT_NEAR(shares[1], 1, 1e-12);
}

TEST(BedWindow, KineticEnergyIsOverWeightTimesDiameter) {
  auto bed = spheres({{0, 0, 1e-3}, {0, 0, 5e-3}});
  bed.velocity[1] = {0, 0, 0.1};
  EXPECT_NEAR(kinetic_energy_over_weight(bed), 0.5 * 0.5 * 0.01 / (9.81 * 2e-3), 1e-12);
  EXPECT_NEAR(top_of(bed), 6e-3, 1e-15);
}

TEST(HeapShadow, OfOneSphereIsACircleAndHolesAreFull) {
  const double circle = std::numbers::pi * 1e-6;
  EXPECT_NEAR(projected_area(spheres({{0, 0, 1e-3}}), 0), circle, 0.02 * circle);
  // A closed ring of spheres has the area within.
  std::vector<Eigen::Vector3d> ring;
  for (int k = 0; k < 16; ++k) {
    const double angle = 2 * std::numbers::pi * k / 16;
    ring.push_back({4e-3 * std::cos(angle), 0, 6e-3 + 4e-3 * std::sin(angle)});
  }
  const double area = projected_area(spheres(ring), 0);
  EXPECT_GT(area, std::numbers::pi * 16e-6);
  EXPECT_LT(area, std::numbers::pi * 25e-6);
}

TEST(HeapShadow, AngleOfATriangleOfSpheresIsItsSlope) {
  // Spheres side by side fill a triangle 60 mm wide and 30 mm high: arctan(2 h / b) of b = 58 mm + 2 mm.
  std::vector<Eigen::Vector3d> heap;
  for (double z = 0.1e-3; z < 29e-3; z += 1e-3)
    for (double x = -29e-3 + z; x <= 29e-3 - z; x += 1e-3) heap.push_back({x, x, z});
  EXPECT_NEAR(area_equivalent_angle(spheres(heap), 58e-3), 45, 1.5);
  EXPECT_EQ(carr_class(29), 0);
  EXPECT_EQ(carr_class(40), 2);
  EXPECT_EQ(carr_class(56), 4);
}

TEST(SpeedDensity, OfASolidBodyRisesLinearly) {
  results::FillResult result;
  results::Instant instant;
  instant.time = 2;
  constexpr int kCount = 20000;  // as many on every area of a disc that turns: p(v) = 2 v / V^2
  for (int k = 0; k < kCount; ++k) instant.velocity.push_back({1.2 * std::sqrt((k + 0.5) / kCount), 0, 0});
  result.instants = {instant, instant};
  result.instants.front().time = 0.5;  // before the last second
  result.instants.front().velocity.assign(10, Eigen::Vector3d(0.1, 0, 0));
  const SpeedDensity density = speed_density(result, 2, 1);
  EXPECT_NEAR(density.mean, 0.8, 1e-3);
  EXPECT_GT(density.linearity(1.0), 0.999);
  EXPECT_NEAR(density.density[10], 2 * density.speed[10] / 1.44, 0.01);
  EXPECT_NEAR(density.peak(), 1.125, 0.051);
  EXPECT_EQ(difference(density, density), 0);
}

TEST(InsertedBed, ANarrowerBedHasAsMuchPowderOnEverySquareMetre) {
  const Insertion narrow = of_width({}, 0.0105);
  EXPECT_NEAR(narrow.mass, 4.2e-3, 1e-12);
  EXPECT_NEAR(narrow.region, 0.010, 1e-12);
  EXPECT_EQ(narrow.to, 0.330);
}

TEST(CohesiveSpheres, OfTwoSizesKnowTheirLargest) {
  CohesiveSpheres two;
  two.sizes = {{5e-4, 8}, {1e-3, 1}};
  EXPECT_NEAR(largest_diameter(two), 4e-3, 1e-15);
}

}  // namespace
}  // namespace diefill::process::laboratory
