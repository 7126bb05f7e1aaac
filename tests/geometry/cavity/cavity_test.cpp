#include "geometry/cavity/cavity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/sample_meshes.h"
#include "tests/geometry/sample_tool_files.h"

namespace diefill::geometry {
namespace {

constexpr double kMillimetre = 1e-3;

// Exact cross-section of a ring between inscribed polygons of 256 corners.
double ring_area(double inner, double outer) {
  return 128 * std::sin(2 * std::numbers::pi / 256) * (outer * outer - inner * inner);
}

Mesh box_mm(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  return sample::box(lower * kMillimetre, upper * kMillimetre);
}

// Four walls and a floor round a space of 10 x 6 x 5 mm with one corner at the origin, top at z = 0.
std::vector<Mesh> open_box() {
  return {box_mm({0, 0, -8}, {10, 6, -5}), box_mm({-2, -2, -8}, {0, 8, 0}), box_mm({10, -2, -8}, {12, 8, 0}),
          box_mm({0, -2, -8}, {10, 0, 0}), box_mm({0, 6, -8}, {10, 8, 0})};
}

std::vector<const Mesh*> pointers(const std::vector<Mesh>& meshes) {
  std::vector<const Mesh*> result;
  for (const auto& mesh : meshes) result.push_back(&mesh);
  return result;
}

Cavity cavity_of(const std::vector<Mesh>& meshes, double fill_plane = 0) {
  return find_cavity(pointers(meshes), fill_plane);
}

std::vector<Mesh> ring_tools(const std::string& folder, const std::string& grain) {
  return {sample::tool(folder + "/die" + grain + ".stl"), sample::tool(folder + "/punch" + grain + ".stl"),
          sample::tool(folder + "/core_rod.stl")};
}

void expect_ring(const Cavity& cavity, double inner_radius, double width, double depth) {
  ASSERT_TRUE(cavity.found);
  ASSERT_TRUE(cavity.is_ring);
  EXPECT_NEAR(cavity.inner_radius, inner_radius, 5e-6);
  EXPECT_NEAR(cavity.outer_radius, inner_radius + width, 5e-6);
  EXPECT_NEAR(cavity.narrowest_width, width, 5e-6);
  EXPECT_NEAR(cavity.axis_origin.x(), 0, 1e-7);
  EXPECT_NEAR(cavity.axis_origin.y(), 0, 1e-7);
  EXPECT_DOUBLE_EQ(cavity.axis_origin.z(), 0);
  EXPECT_NEAR(cavity.box.lower.z(), -depth, 1e-8);
  EXPECT_DOUBLE_EQ(cavity.box.upper.z(), 0);
  EXPECT_NEAR(cavity.box.upper.x(), inner_radius + width, 5e-6);
  EXPECT_NEAR(cavity.box.lower.y(), -inner_radius - width, 5e-6);
  const double exact = ring_area(inner_radius, inner_radius + width) * depth;
  EXPECT_NEAR(cavity.volume, exact, 0.005 * exact);
}

TEST(Cavity, FootprintLeavesOutWhatIsBesideItInItsBox) {
  // An L: the box of 10 x 6 mm without a corner of 5 x 3 mm.
  auto meshes = open_box();
  meshes.push_back(box_mm({5, 3, -8}, {10, 6, 0}));
  const Footprint footprint = cavity_of(meshes).footprint;
  for (const Eigen::Vector2d& inside : {Eigen::Vector2d(1, 1), {1, 5}, {9, 1}, {4.8, 5.8}, {9.8, 2.8}})
    EXPECT_TRUE(footprint.covers(inside * kMillimetre)) << inside.transpose();
  for (const Eigen::Vector2d& beside : {Eigen::Vector2d(9, 5), {5.2, 3.2}, {-1, 1}, {100, 1}, {-100, -100}})
    EXPECT_FALSE(footprint.covers(beside * kMillimetre)) << beside.transpose();
  EXPECT_FALSE(Footprint().covers({0, 0}));
}

TEST(Cavity, FindsOpenBoxOfSeveralBlocks) {
  const auto cavity = cavity_of(open_box());
  ASSERT_TRUE(cavity.found);
  EXPECT_FALSE(cavity.is_ring);
  EXPECT_NEAR(cavity.volume, 300e-9, 0.01 * 300e-9);
  EXPECT_NEAR(cavity.narrowest_width, 6e-3, 1e-9);
  EXPECT_LT((cavity.box.lower - Eigen::Vector3d(0, 0, -5e-3)).norm(), 1e-8);
  EXPECT_LT((cavity.box.upper - Eigen::Vector3d(10e-3, 6e-3, 0)).norm(), 1e-8);
  EXPECT_NEAR(cavity.narrowest_place.y(), 3e-3, 1e-9);
}

// A block of 40 x 20 mm with a pocket of 10 x 6 mm, 5 mm deep, and a shaft of 4 x 4 mm, 8 mm deep.
std::vector<Mesh> two_pockets() {
  return {box_mm({-10, -10, -10}, {30, 10, -8}), box_mm({-10, -10, -8}, {-5, 10, 0}),
          box_mm({-5, 3, -8}, {20, 10, 0}),      box_mm({-5, -10, -8}, {20, -3, 0}),
          box_mm({5, -3, -8}, {20, 3, 0}),       box_mm({-5, -3, -8}, {5, 3, -5}),
          box_mm({24, -10, -8}, {30, 10, 0}),    box_mm({20, 2, -8}, {24, 10, 0}),
          box_mm({20, -10, -8}, {24, -2, 0})};
}

TEST(Cavity, SeveralAreFoundTheLargestFirst) {
  const auto tools = two_pockets();
  const auto cavities = find_cavities(pointers(tools), 0);
  ASSERT_EQ(cavities.size(), 2U);
  EXPECT_NEAR(cavities[0].volume, 300e-9, 0.01 * 300e-9);
  EXPECT_NEAR(cavities[1].volume, 128e-9, 0.01 * 128e-9);
  EXPECT_NEAR(cavities[0].narrowest_width, 6e-3, 1e-8);
  EXPECT_NEAR(cavities[1].narrowest_width, 4e-3, 1e-8);
  EXPECT_NEAR(cavities[1].axis_origin.x(), 22e-3, 1e-7);
  EXPECT_EQ(cavity_of(tools).volume, cavities[0].volume);
}

TEST(Cavity, FillPlaneLimitsItsTop) {
  const auto cavity = cavity_of(open_box(), -2e-3);
  ASSERT_TRUE(cavity.found);
  EXPECT_NEAR(cavity.volume, 180e-9, 0.01 * 180e-9);
  EXPECT_DOUBLE_EQ(cavity.box.upper.z(), -2e-3);
}

TEST(Cavity, NoneWithoutFloor) {
  auto tools = open_box();
  tools.erase(tools.begin());
  EXPECT_FALSE(cavity_of(tools).found);
}

TEST(Cavity, NoneWithoutOneWall) {
  auto tools = open_box();
  tools.pop_back();
  EXPECT_FALSE(cavity_of(tools).found);
}

TEST(Cavity, NoneInFlatTableOrWithoutTools) {
  EXPECT_FALSE(cavity_of({box_mm({-20, -20, -5}, {20, 20, 0})}).found);
  EXPECT_FALSE(find_cavity({}, 0).found);
}

TEST(Cavity, NoneWhereToolsLieAboveFillPlane) {
  EXPECT_FALSE(cavity_of({box_mm({-20, -20, 1}, {20, 20, 5})}).found);
}

TEST(Cavity, FitOfPunchIsClosedButSlotIsOpen) {
  const auto tools = [](double clearance) {
    auto result = open_box();
    result.front() = box_mm({clearance, clearance, -8}, {10 - clearance, 6 - clearance, -5});
    return result;
  };
  EXPECT_TRUE(cavity_of(tools(0.02)).found);
  EXPECT_TRUE(cavity_of(tools(0.19)).found);
  EXPECT_FALSE(cavity_of(tools(0.5)).found);
}

TEST(Cavity, UndercutBelongsToIt) {
  auto tools = open_box();
  // A lid over half of the box leaves a room of 5 x 6 x 4 mm under it.
  tools.push_back(box_mm({5, 0, -1}, {10, 6, 0}));
  const auto cavity = cavity_of(tools);
  ASSERT_TRUE(cavity.found);
  EXPECT_NEAR(cavity.volume, (300 - 30) * 1e-9, 0.01 * 270e-9);
}

TEST(Cavity, LargestOfTwoIsTaken) {
  auto tools = open_box();
  tools.push_back(box_mm({3, 0, -5}, {4, 6, 0}));  // 3 mm to its left, 6 mm to its right
  const auto cavity = cavity_of(tools);
  ASSERT_TRUE(cavity.found);
  EXPECT_NEAR(cavity.volume, 180e-9, 0.01 * 180e-9);
  EXPECT_NEAR(cavity.box.lower.x(), 4e-3, 1e-8);
}

TEST(Cavity, BoreWithoutCoreIsNoRing) {
  const std::vector<Mesh> tools = {sample::bored_block(0.012, 0.01, 0.006, 128),
                                   box_mm({-8, -8, -12}, {8, 8, -10})};
  const auto cavity = cavity_of(tools);
  ASSERT_TRUE(cavity.found);
  EXPECT_FALSE(cavity.is_ring);
  EXPECT_NEAR(cavity.narrowest_width, 0.012, 1e-5);
  const double exact = 64 * std::sin(2 * std::numbers::pi / 128) * 36e-6 * 0.01;
  EXPECT_NEAR(cavity.volume, exact, 0.005 * exact);
}

TEST(Cavity, CoreOffCentreIsNoRing) {
  const Mesh core =
      transformed(sample::cylinder(0.003, 0.01, 128), Eigen::Matrix3d::Identity(), {0.001, 0, -0.01});
  const std::vector<Mesh> tools = {sample::bored_block(0.012, 0.01, 0.006, 128),
                                   box_mm({-8, -8, -12}, {8, 8, -10}), core};
  const auto cavity = cavity_of(tools);
  ASSERT_TRUE(cavity.found);
  EXPECT_FALSE(cavity.is_ring);
  EXPECT_NEAR(cavity.narrowest_width, 0.002, 1e-5);
  EXPECT_NEAR(cavity.narrowest_place.x(), 0.005, 1e-4);
}

TEST(Cavity, RingAwayFromOriginIsFoundWhereItIs) {
  const Eigen::Vector3d shift(0.0313, -0.0127, 0.005);
  std::vector<Mesh> tools = ring_tools("narrow_ring", "_d0.94");
  for (auto& tool : tools) tool = transformed(tool, Eigen::Matrix3d::Identity(), shift);
  const auto cavity = cavity_of(tools, shift.z());
  ASSERT_TRUE(cavity.is_ring);
  EXPECT_LT((cavity.axis_origin - shift).norm(), 1e-7);
  EXPECT_NEAR(cavity.narrowest_width, 3.146e-3, 5e-6);
}

TEST(Cavity, NarrowRingsHaveTheirPublishedWidths) {
  expect_ring(cavity_of(ring_tools("narrow_ring", "_d0.47")), 8e-3, 2.488e-3, 20e-3);
  expect_ring(cavity_of(ring_tools("narrow_ring", "_d0.94")), 8e-3, 3.146e-3, 20e-3);
  expect_ring(cavity_of(ring_tools("narrow_ring", "_d1.88")), 8e-3, 4.462e-3, 20e-3);
}

TEST(Cavity, CircularCavitiesAndWideRing) {
  expect_ring(cavity_of(ring_tools("circular_cavity", "_d0.47")), 8e-3, 2e-3, 15e-3);
  expect_ring(cavity_of(ring_tools("circular_cavity", "_d1.88")), 8e-3, 3.974e-3, 15e-3);
  expect_ring(cavity_of(ring_tools("wide_ring", "")), 8e-3, 8e-3, 20e-3);
}

TEST(Cavity, SteppedRingIsAsNarrowAsItsLowerPart) {
  const auto cavity = cavity_of(ring_tools("stepped_ring", ""));
  ASSERT_TRUE(cavity.is_ring);
  EXPECT_NEAR(cavity.inner_radius, 8e-3, 5e-6);
  EXPECT_NEAR(cavity.outer_radius, 16e-3, 5e-6);
  EXPECT_NEAR(cavity.narrowest_width, 3.15e-3, 5e-6);
  EXPECT_LT(cavity.narrowest_place.z(), -10e-3);
  const double exact = (ring_area(8e-3, 11.15e-3) + ring_area(8e-3, 16e-3)) * 10e-3;
  EXPECT_NEAR(cavity.volume, exact, 0.005 * exact);
}

TEST(Cavity, RectangularDieIsTwelveMillimetresWide) {
  const auto cavity =
      cavity_of({sample::tool("rectangular_die/die.stl"), sample::tool("rectangular_die/punch.stl")});
  ASSERT_TRUE(cavity.found);
  EXPECT_FALSE(cavity.is_ring);
  EXPECT_NEAR(cavity.narrowest_width, 12e-3, 1e-8);
  EXPECT_NEAR(cavity.volume, 5400e-9, 0.005 * 5400e-9);
  EXPECT_NEAR(cavity.box.lower.z(), -15e-3, 1e-8);
}

// A bar along y, 12 mm long, with the cross-section `polygon` in x and z (mm, counter-clockwise).
Mesh bar_mm(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& hub) {
  std::vector<Eigen::Vector2d> corners;
  for (const auto& corner : polygon) corners.push_back(corner * kMillimetre);
  Eigen::Matrix3d upright;
  upright << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return transformed(sample::prism(corners, hub * kMillimetre, 12e-3), upright, {0, 12e-3, 0});
}

// A groove of 8 mm, straight down to z = -6 mm, then closing at 45 degrees down to `floor` mm, where it is
// flat.
std::vector<Mesh> groove(double floor) {
  const double half = 4 - (-6 - floor);
  return {bar_mm({{-10, -12}, {-half, -12}, {-half, floor}, {-4, -6}, {-4, 0}, {-10, 0}}, {-8, -11}),
          bar_mm({{half, -12}, {10, -12}, {10, 0}, {4, 0}, {4, -6}, {half, floor}}, {8, -11}),
          box_mm({-10, 0, -14}, {10, 12, floor}), box_mm({-10, -2, -14}, {10, 0, 0}),
          box_mm({-10, 12, -14}, {10, 14, 0})};
}

TEST(Cavity, TipOfGrooveIsLeftOutUpToTwoPerCentOfTheVolume) {
  const auto cavity = cavity_of(groove(-10));
  ASSERT_TRUE(cavity.found);
  EXPECT_NEAR(cavity.volume, 64 * 12e-9, 0.01 * 64 * 12e-9);
  EXPECT_NEAR(cavity.narrowest_width, 2e-3 * std::sqrt(0.02 * 64), 0.3e-3);
}

TEST(Cavity, ChamferAtTheFloorDoesNotMakeItNarrower) {
  EXPECT_NEAR(cavity_of(groove(-6.1)).narrowest_width, 8e-3, 1e-6);
}

TEST(Cavity, SlotInTheFloorCountsHoweverSmall) {
  auto tools = open_box();  // 10 x 6 mm; its floor is 3 mm thick
  tools.front() = box_mm({0, 0, -8}, {4.5, 6, -5});
  tools.push_back(box_mm({5.5, 0, -8}, {10, 6, -5}));
  tools.push_back(box_mm({0, 0, -8}, {10, 6, -5.5}));  // a slot of 1 mm, 0.5 mm deep: 1 % of the volume
  EXPECT_NEAR(cavity_of(tools).narrowest_width, 1e-3, 1e-6);
}

TEST(Cavity, TipBesideADeeperPocketIsLeftOutToo) {
  auto tools = groove(-10);
  for (auto& tool : tools) tool = transformed(tool, Eigen::Matrix3d::Identity(), {-10e-3, 0, 0});
  tools.erase(tools.begin() + 1);
  // From the tip at x = -10 on: a bar up to the floor of a pocket of 5 mm, 13 mm deep; above -6 they are one.
  tools.push_back(bar_mm({{-10, -12}, {0, -12}, {0, -6}, {-6, -6}, {-10, -10}}, {-4, -9}));
  tools.push_back(box_mm({5, 0, -14}, {10, 12, 0}));
  tools.push_back(box_mm({0, 0, -14}, {5, 12, -13}));
  tools.push_back(box_mm({0, -2, -14}, {10, 0, 0}));
  tools.push_back(box_mm({0, 12, -14}, {10, 14, 0}));
  const auto cavity = cavity_of(tools);
  ASSERT_TRUE(cavity.found);
  EXPECT_NEAR(cavity.box.lower.z(), -13e-3, 1e-7);
  EXPECT_GT(cavity.narrowest_width, 2e-3);
  EXPECT_LT(cavity.narrowest_width, 5e-3 + 1e-6);
}

TEST(Cavity, RingWithATaperingBottomIsARing) {
  auto tools = ring_tools("wide_ring", "");
  ASSERT_TRUE(cavity_of(tools).is_ring);
  // Another punch 45 degrees steep: its top falls from the die's wall to the core rod.
  const Box box = tools[1].bounding_box();
  auto& points = tools[1].vertices;
  for (auto& point : points) {
    const double radius = point.head<2>().norm();
    if (point.z() > box.upper.z() - 1e-6) point.z() += 0.2 * (radius - 8e-3);
  }
  const auto cavity = cavity_of(tools);
  ASSERT_TRUE(cavity.found);
  EXPECT_TRUE(cavity.is_ring);
  EXPECT_GT(cavity.narrowest_width, 2e-3);
}

TEST(Cavity, SlitPlatesHaveNone) {
  EXPECT_FALSE(cavity_of({sample::tool("slit_plate/slit_6mm.stl")}).found);
  EXPECT_FALSE(cavity_of({sample::tool("slit_plate/slit_10mm.stl")}).found);
}

}  // namespace
}  // namespace diefill::geometry
