#include "geometry/cavity/side_opening.h"

#include <gtest/gtest.h>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

Mesh box_mm(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  return sample::box(1e-3 * lower, 1e-3 * upper);
}

/// Four walls and a floor round a space of 10 x 6 x 5 mm with a corner in the origin, top at z = 0; the wall
/// at x = 10 mm up to `height` mm between y = 2 and 4 mm.
std::vector<Mesh> box_with_slot(double height) {
  return {box_mm({0, 0, -8}, {10, 6, -5}),     box_mm({-2, -2, -8}, {0, 8, 0}),
          box_mm({0, -2, -8}, {10, 0, 0}),     box_mm({0, 6, -8}, {10, 8, 0}),
          box_mm({10, -2, -8}, {12, 2, 0}),    box_mm({10, 4, -8}, {12, 8, 0}),
          box_mm({10, 2, -8}, {12, 4, height})};
}

std::optional<SideOpening> opening_of(const std::vector<Mesh>& meshes, double fill_plane = 0) {
  std::vector<const Mesh*> pointers;
  for (const auto& mesh : meshes) pointers.push_back(&mesh);
  return find_side_opening(pointers, fill_plane);
}

TEST(SideOpening, IsFoundWithItsHeightAndPlace) {
  const auto opening = opening_of(box_with_slot(-3));
  ASSERT_TRUE(opening);
  EXPECT_NEAR(opening->height, -3e-3, 1e-9);
  EXPECT_NEAR(opening->place.x(), 12e-3, 2e-4);
  EXPECT_GT(opening->place.y(), 2e-3);
  EXPECT_LT(opening->place.y(), 4e-3);
  EXPECT_NEAR(opening->volume, 120e-9, 12e-9);
}

TEST(SideOpening, IsNoneWhereAllSidesAreClosed) {
  EXPECT_FALSE(opening_of(box_with_slot(0)));
}

TEST(SideOpening, AboveTheFillPlaneCountsForNothing) {
  EXPECT_FALSE(opening_of(box_with_slot(-3), -3.5e-3));
}

TEST(SideOpening, IsNoneWhereNothingStaysInside) {
  EXPECT_FALSE(opening_of(box_with_slot(-5)));
  EXPECT_FALSE(opening_of({box_mm({0, 0, -5}, {10, 10, 0})}));
  EXPECT_FALSE(opening_of({}));
}

}  // namespace
}  // namespace diefill::geometry
