// Wall spheres where walls meet or are thin: inner edges, wedges, cusps, needles, plates.
#include <numbers>

#include "tests/geometry/sample_tool_files.h"
#include "tests/geometry/wall_spheres/wall_sphere_support.h"

namespace diefill::geometry {
namespace {

using namespace wall_sphere_tests;

TEST(WallSpheres, CloseTheInnerEdgeOfAnL) {
  const Mesh mesh =
      sample::prism({{0, 0}, {0.006, 0}, {0.006, 0.002}, {0.002, 0.002}, {0.002, 0.006}, {0, 0.006}},
                    {0.001, 0.001}, 0.004);
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
  // Straight through the edge on the bisector of the corner, where a sphere would leak.
  const double below = 0.002 - kRadius / std::sqrt(2);
  EXPECT_LE(widest_along(spheres, {below, below, kRadius}, {below, below, 0.004 - kRadius}), kRadius * 1.14);
}

TEST(WallSpheres, RoundOffASharpWedge) {
  const double angle = std::numbers::pi / 6;
  const Mesh mesh =
      sample::prism({{0, 0}, {0.006, 0}, {0.006, 0.006 * std::tan(angle)}}, {0.004, 0.001}, 0.003);
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
  // The sphere that touches both faces leaves the tip empty: R / sin(angle / 2) - R.
  const double tip = kRadius / std::sin(angle / 2) - kRadius;
  EXPECT_NEAR(spheres.largest_deviation, tip, 0.1 * tip);
  EXPECT_NEAR(spheres.largest_deviation_place.head<2>().norm(), 0, 0.2 * kRadius);
}

TEST(WallSpheres, TipsOfSharpBladesAreRoundedNotOpen) {
  WallSphereOptions wanted = options();
  wanted.radius = 6e-4;
  const WallSpheres spheres = make_wall_spheres(sample::tool("laboratory/mixer_impeller.stl"), wanted);
  // Spheres that touch both faces leave a tip empty up to 2.7 R. Between spheres the gap is that of a square
  // grid, or a little more where the blades are curved.
  EXPECT_GT(spheres.largest_deviation, 2.5 * wanted.radius);
  EXPECT_LT(spheres.largest_gap, 0.5 * wanted.radius);
}

/// What a round hole leaves of an inner corner: a pillar of three sides, one of them bent, with two cusps.
Mesh pillar_beside_a_hole() {
  constexpr double kHole = 4.5e-3;         // m
  const Eigen::Vector2d axis(3e-3, 4e-3);  // of the hole, seen from the corner
  const double from = -std::acos(-axis.x() / kHole), to = -std::numbers::pi + std::asin(axis.y() / kHole);
  constexpr int kFacets = 6;
  std::vector<Eigen::Vector2d> corners = {{0, 0}};
  for (int n = 0; n <= kFacets; ++n) {
    const double angle = to + (from - to) * n / kFacets;
    corners.push_back(axis + kHole * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return sample::prism(corners, {1e-4, 1e-4}, 3e-3);
}

TEST(WallSpheres, RoundOffTheCuspsOfAPillarBesideARoundHole) {
  WallSphereOptions wanted = options();
  wanted.radius = 2e-4;
  const WallSpheres spheres = make_wall_spheres(pillar_beside_a_hole(), wanted);
  EXPECT_GT(spheres.centres.size(), 0U);
  EXPECT_LT(spheres.largest_deviation, 5 * wanted.radius);
}

TEST(WallSpheres, RefuseAPlateThinnerThanASphere) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.005, 0.005, 1.9 * kRadius));
  try {
    make_wall_spheres(mesh, options());
    FAIL() << "a plate of 1.9 R was taken";
  } catch (const ThinSolid& thin) {
    const std::string message = thin.what();
    EXPECT_NE(message.find("only 0.285 mm thick"), std::string::npos) << message;
    EXPECT_NE(message.find("thicken the part"), std::string::npos) << message;
    EXPECT_NEAR(thin.thickness, 1.9 * kRadius, 1e-9);
  }
}

TEST(WallSpheres, FillAPlateOfExactlyOneSphere) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.005, 0.005, 2 * kRadius));
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
}

TEST(WallSpheres, CoverNeedlesThatMeetInAPoint) {
  // As CAD programs like to cut a plate with a round hole: a fan of needles from the plate's far corner.
  std::vector<Eigen::Vector2d> outline = {{45e-3, -2e-3}, {45e-3, 2e-3}};
  constexpr int kNeedles = 80;
  for (int k = 0; k <= kNeedles; ++k) {
    const double angle = (0.5 + static_cast<double>(k) / kNeedles) * std::numbers::pi;
    outline.emplace_back(5e-3 * std::cos(angle), 5e-3 * std::sin(angle));
  }
  constexpr double kHeight = 3e-3;
  const Mesh mesh = sample::prism(outline, {44e-3, 0}, kHeight);
  auto wanted = options();
  wanted.reachable = [](const Eigen::Vector3d&, const Eigen::Vector3d& normal) { return normal.z() > 0.5; };
  const auto spheres = make_wall_spheres(mesh, wanted);
  const double depth = kHeight - kRadius;
  for (const double x : {43e-3, 40e-3, 36e-3, 25e-3})
    EXPECT_LE(widest_along(spheres, {x, -1.5e-3, depth}, {x, 1.5e-3, depth}), kSpacing / std::sqrt(2) * 1.001)
        << x;
}

}  // namespace
}  // namespace diefill::geometry
