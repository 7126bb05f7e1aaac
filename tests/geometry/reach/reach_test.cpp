#include "geometry/reach/reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/sample_meshes.h"
#include "tests/geometry/sample_tool_files.h"

namespace diefill::geometry {
namespace {

using Eigen::Vector3d;

const Vector3d kUp = Vector3d::UnitZ();

Mesh box_mm(const Vector3d& lower, const Vector3d& upper) {
  return sample::box(lower * 1e-3, upper * 1e-3);
}

Box space_mm(const Vector3d& lower, const Vector3d& upper) {
  return {lower * 1e-3, upper * 1e-3};
}

MovingSolid standing(const Mesh& mesh, std::size_t samples = 1) {
  return {&mesh, std::vector<Eigen::Matrix3d>(samples, Eigen::Matrix3d::Identity()),
          std::vector<Vector3d>(samples, Vector3d::Zero())};
}

MovingSolid moving(const Mesh& mesh, const std::vector<Vector3d>& path) {
  return {&mesh, std::vector<Eigen::Matrix3d>(path.size(), Eigen::Matrix3d::Identity()), path};
}

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

bool at(const Reach& reach, std::size_t solid, const Vector3d& millimetres, const Vector3d& normal) {
  return reach.reachable(solid, millimetres * 1e-3, normal, 2e-4);
}

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

TEST(Reach, VolumeIsThatOfThePowderBox) {
  const Frame frame;
  const Reach reach(frame.request);
  // Voxels of 0.5 mm beginning at -22.2 mm put 20 centres between the walls either way, 10 of them beyond x =
  // 0.
  EXPECT_NEAR(reach.volume_below(8e-3, frame.request.domain), 800e-9, 1e-15);
  EXPECT_NEAR(reach.volume_below(4e-3, frame.request.domain), 400e-9, 1e-15);
  EXPECT_NEAR(reach.volume_below(4e-3, space_mm({0, -22, 0}, {22, 22, 1})), 200e-9, 1e-15);
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

// The narrow ring as it is run: the shoe from 35.4 mm to -35.4 mm over the plate, poured from 110 mm.
class ReachOfNarrowRing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const char* file : {"die_d1.88", "core_rod", "punch_d1.88", "shoe"})
      tools_.push_back(sample::tool(std::string("narrow_ring/") + file + ".stl"));
    std::vector<Vector3d> path;
    for (int i = 0; i <= 30; ++i) path.emplace_back(35.4e-3 - 70.8e-3 * i / 30, 0, 0);
    ReachRequest request;
    for (std::size_t i = 0; i < 3; ++i) request.solids.push_back(standing(tools_[i], path.size()));
    request.solids.push_back(moving(tools_[3], path));
    request.powder = {space_mm({19.4, -14.5, 0}, {51.4, 14.5, 110})};
    request.domain = space_mm({-55.46, -18.5, -25}, {55.46, 18.5, 114});
    request.climb = 3.76e-3;
    request.voxel = 4.7e-4;
    reach_ = std::make_unique<Reach>(request);
  }
  static void TearDownTestSuite() {
    reach_.reset();
    tools_.clear();
  }
  static bool touched(std::size_t tool, const Vector3d& millimetres, const Vector3d& normal) {
    return reach_->reachable(tool, millimetres * 1e-3, normal, 1.88e-3);
  }
  static inline std::vector<Mesh> tools_;
  static inline std::unique_ptr<Reach> reach_;
};

TEST_F(ReachOfNarrowRing, CavityIsTouchedAllOver) {
  for (int degree = 0; degree < 360; degree += 5) {
    const double angle = degree * std::numbers::pi / 180;
    const Vector3d outward(std::cos(angle), std::sin(angle), 0);
    for (const double z : {-0.2, -10.0, -19.8}) {
      EXPECT_TRUE(touched(0, 12.462 * outward + z * kUp, -outward)) << degree << ' ' << z;
      EXPECT_TRUE(touched(1, 8 * outward + z * kUp, outward)) << degree << ' ' << z;
    }
    EXPECT_TRUE(touched(2, 10 * outward - 20 * kUp, kUp)) << degree;
    EXPECT_TRUE(touched(1, 4 * outward, kUp)) << degree;
  }
}

TEST_F(ReachOfNarrowRing, OutsideOfToolsIsNot) {
  for (double x = -50; x <= 50; x += 5) {
    EXPECT_FALSE(touched(0, {x, 18.5, -5}, Vector3d::UnitY())) << x;
    EXPECT_FALSE(touched(0, {x, -18.5, -0.5}, -Vector3d::UnitY())) << x;
    EXPECT_FALSE(touched(0, {x, 0, -25}, -kUp)) << x;
  }
  EXPECT_FALSE(touched(0, {55.46, 0, -1}, Vector3d::UnitX()));
  EXPECT_FALSE(touched(0, {-55.46, 0, -1}, -Vector3d::UnitX()));
  EXPECT_FALSE(touched(1, {0, 0, -25}, -kUp));
  EXPECT_FALSE(touched(2, {10, 0, -25}, -kUp));
  EXPECT_FALSE(touched(2, {12.44, 0, -23}, Vector3d::UnitX()));
}

TEST_F(ReachOfNarrowRing, ShoeIsTouchedInsideOnly) {
  for (const double z : {0.5, 20.0, 45.0}) {
    EXPECT_TRUE(touched(3, {16, 0, z}, -Vector3d::UnitX())) << z;
    EXPECT_TRUE(touched(3, {0, 14.5, z}, -Vector3d::UnitY())) << z;
  }
  for (const double z : {10.0, 45.0}) {
    EXPECT_FALSE(touched(3, {19, 0, z}, Vector3d::UnitX())) << z;
    EXPECT_FALSE(touched(3, {-19, 0, z}, -Vector3d::UnitX())) << z;
    EXPECT_FALSE(touched(3, {0, 17.5, z}, Vector3d::UnitY())) << z;
  }
  EXPECT_FALSE(touched(3, {17.5, 0, 46}, kUp));
  EXPECT_TRUE(touched(3, {17.5, 0, 0}, -kUp));  // its sole slides over the open ring
}

TEST_F(ReachOfNarrowRing, PlateIsTouchedUnderTheWayOfTheShoe) {
  EXPECT_TRUE(touched(0, {35, 0, 0}, kUp));
  EXPECT_TRUE(touched(0, {-35, 10, 0}, kUp));
  EXPECT_FALSE(touched(0, {54.9, 0, 0}, kUp));
  EXPECT_FALSE(touched(0, {40, 18.2, 0}, kUp));
}

TEST(ReachOfSlitPlate, PowderFallsThroughTheSlitOfAPeriodicSlice) {
  const Mesh plate = sample::tool("slit_plate/slit_6mm.stl"), shoe = sample::tool("shoe/shoe_tall.stl");
  std::vector<Vector3d> path;
  for (int i = 0; i <= 40; ++i) path.emplace_back(58e-3 - 116e-3 * i / 40, 0, 0);
  ReachRequest request;
  request.solids = {standing(plate, path.size()), moving(shoe, path)};
  request.powder = {space_mm({42, -1.08, 0}, {74, 1.08, 98})};
  request.domain = space_mm({-78, -1.08, -2}, {78, 1.08, 100});
  request.climb = 1e-3;
  request.voxel = 2.5e-4;
  const Reach reach(request);
  EXPECT_TRUE(at(reach, 0, {-3, 0, -1}, Vector3d::UnitX()));
  EXPECT_TRUE(at(reach, 0, {3, 0, -1}, -Vector3d::UnitX()));
  EXPECT_TRUE(at(reach, 0, {-50, 0, 0}, kUp));
  EXPECT_FALSE(at(reach, 0, {30, 0, -2}, -kUp));
  EXPECT_FALSE(at(reach, 0, {77.5, 0, 0}, kUp));
  EXPECT_TRUE(at(reach, 1, {-16, 0, 20}, Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {-19, 0, 20}, -Vector3d::UnitX()));
  EXPECT_FALSE(at(reach, 1, {17, 0, 46}, kUp));
}

}  // namespace
}  // namespace diefill::geometry
