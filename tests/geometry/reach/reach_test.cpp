#include "geometry/reach/reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/reach_request.h"

namespace diefill::geometry {
namespace {

// A frame of 10 x 10 x 20 mm inside and walls 2 mm thick on a table 40 mm wide, powder 8 mm high in it.
struct Frame {
  Mesh table = box_mm({-20, -20, -4}, {20, 20, 0});
  Mesh left = box_mm({-7, -7, 0}, {-5, 7, 20}), right = box_mm({5, -7, 0}, {7, 7, 20});
  Mesh front = box_mm({-5, -7, 0}, {5, -5, 20}), back = box_mm({-5, 5, 0}, {5, 7, 20});
  ReachRequest request;

  Frame() {
    for (const auto* mesh : {&table, &left, &right, &front, &back}) request.solids.push_back(standing(*mesh));
    request.powder = {space_mm({-5, -5, 0}, {5, 5, 8})};
    request.domain = space_mm({-22.2, -22.2, -6}, {22.3, 22.3, 40});
    request.voxel = 5e-4;
  }
};

TEST(Reach, InsideOfFrameIsReachedAndOutsideIsNot) {
  const Frame frame;
  const Reach reach(frame.request);
  EXPECT_TRUE(at(reach, 0, {0, 0, 0}, kUp));
  EXPECT_TRUE(at(reach, 0, {-4.9, 4.9, 0}, kUp));
  EXPECT_FALSE(at(reach, 0, {10, 0, 0}, kUp));
  EXPECT_FALSE(at(reach, 0, {0, 0, -4}, -kUp));
  EXPECT_FALSE(at(reach, 0, {20, 0, -2}, Vector3d::UnitX()));
  EXPECT_TRUE(at(reach, 1, {-5, 0, 4}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {-7, 0, 4}, -Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {-6, 0, 20}, kUp));
}

TEST(Reach, PowderStandsAsHighAsPouredPlusClimb) {
  Frame frame;
  EXPECT_TRUE(at(Reach(frame.request), 1, {-5, 0, 7.9}, Vector3d::UnitX()));
  EXPECT_FALSE(at(Reach(frame.request), 1, {-5, 0, 10}, Vector3d::UnitX()));
  frame.request.climb = 4e-3;
  EXPECT_TRUE(at(Reach(frame.request), 1, {-5, 0, 11.9}, Vector3d::UnitX()));
  EXPECT_FALSE(at(Reach(frame.request), 1, {-5, 0, 14}, Vector3d::UnitX()));
}

TEST(Reach, PowderPouredFromAboveTheRimStaysInside) {
  Frame frame;
  frame.request.powder = {space_mm({-5, -5, 0}, {5, 5, 35})};
  frame.request.climb = 3e-3;
  const Reach reach(frame.request);
  EXPECT_TRUE(at(reach, 1, {-5, 0, 19.5}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {-6, 0, 20}, kUp));
  EXPECT_FALSE(at(reach, 1, {-7, 0, 10}, -Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 0, {10, 0, 0}, kUp));
}

TEST(Reach, PowderThatComesInHigherUpGetsToWallsThere) {
  Frame frame;
  EXPECT_FALSE(at(Reach(frame.request), 1, {-5, 0, 15}, Vector3d::UnitX()));
  frame.request.powder.push_back(space_mm({-3, -3, 14}, {3, 3, 16}));
  const Reach reach(frame.request);
  EXPECT_TRUE(at(reach, 1, {-5, 0, 15}, Vector3d::UnitX()));
  EXPECT_TRUE(at(reach, 1, {-5, 0, 11}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {-7, 0, 10}, -Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 0, {10, 0, 0}, kUp));
}

TEST(Reach, WithoutOneWallItRunsOutOverTheTable) {
  Frame frame;
  frame.request.solids.pop_back();
  const Reach reach(frame.request);
  EXPECT_TRUE(at(reach, 0, {10, 0, 0}, kUp));
  EXPECT_TRUE(at(reach, 1, {-7, 0, 4}, -Vector3d::UnitX()));
  EXPECT_TRUE(at(reach, 0, {20, 0, -2}, Vector3d::UnitX()));
}

TEST(Reach, ClosedBelowOneVoxelAndOpenAboveIt) {
  for (const auto& [gap, open] : {std::pair{0.3, false}, {0.8, true}}) {
    Frame frame;
    frame.back = box_mm({-5, 5, gap}, {5, 7, 20});
    const Reach reach(frame.request);
    EXPECT_EQ(at(reach, 0, {0, 10, 0}, kUp), open) << gap;
  }
}

TEST(Reach, WallThinnerThanVoxelHoldsPowder) {
  Frame frame;
  frame.back = box_mm({-5, 5, 0}, {5, 5.05, 20});
  EXPECT_FALSE(at(Reach(frame.request), 0, {0, 10, 0}, kUp));
}

// Inside a U-shaped duct powder comes up the other side by no more than its climb.
TEST(Reach, DoesNotRiseLikeWater) {
  const Mesh outer_left = box_mm({-12, -5, -1}, {-10, 5, 30}),
             outer_right = box_mm({10, -5, -1}, {12, 5, 30});
  const Mesh bottom = box_mm({-12, -5, -3}, {12, 5, -1}), divider = box_mm({-1, -5, 3}, {1, 5, 30});
  ReachRequest request;
  for (const auto* mesh : {&outer_left, &outer_right, &bottom, &divider})
    request.solids.push_back(standing(*mesh));
  request.powder = {space_mm({-10, -5, 10}, {-1, 5, 20})};
  request.domain = space_mm({-13.2, -5, -4.1}, {13.3, 5, 32});
  request.climb = 4e-3;
  const Reach reach(request);
  EXPECT_TRUE(at(reach, 2, {5, 0, -1}, kUp));
  EXPECT_TRUE(at(reach, 3, {1, 0, 6}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 3, {1, 0, 9}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {10, 0, 9}, -Vector3d::UnitX()));
}

TEST(Reach, HeapRunsOutOverFourThirdsOfItsHeightUnlessItIsScattered) {
  // A trough full to its rim at z = 0 in a table, under two walls that are lifted off.
  const Mesh left = box_mm({-30, -2, -5}, {-5, 2, 0}), right = box_mm({5, -2, -5}, {30, 2, 0});
  const Mesh bottom = box_mm({-5, -2, -7}, {5, 2, -5});
  const Mesh left_wall = box_mm({-7, -2, 0}, {-5, 2, 10}), right_wall = box_mm({5, -2, 0}, {7, 2, 10});
  ReachRequest request;
  for (const auto* mesh : {&left, &right, &bottom}) request.solids.push_back(standing(*mesh, 2));
  for (const auto* mesh : {&left_wall, &right_wall})
    request.solids.push_back(moving(*mesh, {{0, 0, 0}, {0, 0, 0.02}}));
  request.powder = {space_mm({-5, -2, -5}, {5, 2, -0.1})};
  request.domain = space_mm({-30, -2, -8}, {30, 2, 25});
  request.climb = 6e-3;
  const Reach reach(request);
  EXPECT_TRUE(at(reach, 1, {5 + 7, 0, 0}, kUp));
  EXPECT_FALSE(at(reach, 1, {5 + 9, 0, 0}, kUp));
  EXPECT_TRUE(at(reach, 0, {-5 - 7, 0, 0}, kUp));
  EXPECT_FALSE(at(reach, 0, {-5 - 9, 0, 0}, kUp));
  // Where tools throw it about it comes anywhere.
  request.scatters = true;
  const Reach scattered(request);
  EXPECT_TRUE(at(scattered, 1, {29, 0, 0}, kUp));
  EXPECT_TRUE(at(scattered, 0, {-29, 0, 0}, kUp));
}

TEST(Reach, ShoeCarriesPowderAlongAndLeavesItInThePit) {
  Frame frame;
  // A pit 4 x 4 x 3 mm far from where the powder starts; the table is made of five blocks around it.
  const Mesh west = box_mm({-60, -20, -4}, {-42, 20, 0}), east = box_mm({-38, -20, -4}, {20, 20, 0});
  const Mesh south = box_mm({-42, -20, -4}, {-38, -2, 0}), north = box_mm({-42, 2, -4}, {-38, 20, 0});
  const Mesh floor = box_mm({-42, -2, -4}, {-38, 2, -3});
  std::vector<Vector3d> path;
  for (int i = 0; i <= 26; ++i) path.emplace_back(-2e-3 * i, 0, 0);
  ReachRequest request = frame.request;
  request.solids.clear();
  for (const auto* mesh : {&west, &east, &south, &north, &floor})
    request.solids.push_back(standing(*mesh, path.size()));
  for (const auto* mesh : {&frame.left, &frame.right, &frame.front, &frame.back})
    request.solids.push_back(moving(*mesh, path));
  request.domain = space_mm({-70.2, -22.2, -6.2}, {22.3, 22.3, 40});
  const Reach reach(request);
  EXPECT_TRUE(at(reach, 4, {-40, 0, -3}, kUp));                // the pit's floor
  EXPECT_TRUE(at(reach, 0, {-42, 0, -1}, Vector3d::UnitX()));  // its wall
  EXPECT_TRUE(at(reach, 1, {-20, 0, 0}, kUp));                 // the table under the way
  EXPECT_FALSE(at(reach, 1, {-20, 9, 0}, kUp));                // beside it
  EXPECT_FALSE(at(reach, 1, {12, 0, 0}, kUp));                 // behind it
  EXPECT_FALSE(at(reach, 4, {-40, 0, -4}, -kUp));              // under the floor
  EXPECT_TRUE(at(reach, 5, {-6, 0, 0}, -kUp));                 // the shoe's sole passed over the pit
  EXPECT_FALSE(at(reach, 5, {-6, 6, 0}, -kUp));                // but not here
  EXPECT_TRUE(at(reach, 6, {5, 0, 7}, -Vector3d::UnitX()));    // inside the trailing wall
  EXPECT_FALSE(at(reach, 6, {7, 0, 7}, Vector3d::UnitX()));    // outside it
  EXPECT_FALSE(at(reach, 5, {-7, 0, 7}, -Vector3d::UnitX()));  // in front of the shoe
}

TEST(Reach, CoarseSamplesCarryPowderToo) {
  Frame frame;
  frame.table = box_mm({-80, -20, -4}, {20, 20, 0});
  const std::vector<Vector3d> path = {{0, 0, 0}, {-0.025, 0, 0}, {-0.05, 0, 0}};
  ReachRequest request = frame.request;
  request.solids = {standing(frame.table, path.size())};
  for (const auto* mesh : {&frame.left, &frame.right, &frame.front, &frame.back})
    request.solids.push_back(moving(*mesh, path));
  request.domain = space_mm({-85.2, -22.2, -6.2}, {22.3, 22.3, 40});
  const Reach reach(request);
  for (const double x : {0.0, -25.0, -50.0}) EXPECT_TRUE(at(reach, 0, {x, 0, 0}, kUp)) << x;
  EXPECT_FALSE(at(reach, 0, {10, 0, 0}, kUp));
  EXPECT_FALSE(at(reach, 2, {7, 0, 7}, Vector3d::UnitX()));
}

TEST(Reach, RisingPunchLiftsPowder) {
  Frame frame;
  const Mesh punch = box_mm({-5, -5, -4}, {5, 5, 0});
  const Mesh plate = sample::box({-0.02, -0.02, -0.03}, {0.02, 0.02, -0.02});
  std::vector<Vector3d> path;
  for (int i = 0; i <= 5; ++i) path.emplace_back(0, 0, 1e-3 * i);
  ReachRequest request = frame.request;
  request.solids = {standing(plate, path.size()), moving(punch, path)};
  for (const auto* mesh : {&frame.left, &frame.right, &frame.front, &frame.back})
    request.solids.push_back(standing(*mesh, path.size()));
  const Reach reach(request);
  EXPECT_TRUE(at(reach, 1, {0, 0, 0}, kUp));
  EXPECT_TRUE(at(reach, 2, {-5, 0, 12.5}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 2, {-5, 0, 15}, Vector3d::UnitX()));
}

TEST(Reach, TurnedSolidIsAskedInItsOwnFrame) {
  Frame frame;
  const Eigen::Matrix3d quarter = Eigen::AngleAxisd(std::numbers::pi / 2, kUp).toRotationMatrix();
  frame.request.solids[1].rotations = {quarter};
  frame.request.solids[1].translations = {Vector3d(0, 0, 0)};
  frame.request.solids[3].rotations = {quarter.transpose()};
  // The left wall now stands in front and the front wall on the left: 14 mm and 10 mm long, so corners stay
  // closed only where they overlap; the powder box is kept away from them.
  frame.left = box_mm({-7, -7, 0}, {-5, 7, 20});
  frame.front = box_mm({-7, -7, 0}, {7, -5, 20});
  const Reach reach(frame.request);
  EXPECT_TRUE(at(reach, 1, {-5, 0, 4}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {-7, 0, 4}, -Vector3d::UnitX()));
  EXPECT_TRUE(at(reach, 3, {0, -5, 4}, Vector3d::UnitY()));
}

TEST(Reach, RefusesUnequalNumbersOfPoses) {
  Frame frame;
  frame.request.solids[1].translations.emplace_back(0, 0, 0);
  EXPECT_THROW(Reach{frame.request}, std::invalid_argument);
}

}  // namespace
}  // namespace diefill::geometry
