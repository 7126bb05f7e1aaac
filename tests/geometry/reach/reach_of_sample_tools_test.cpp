#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "tests/geometry/reach_request.h"
#include "tests/geometry/sample_tool_files.h"

namespace diefill::geometry {
namespace {

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
