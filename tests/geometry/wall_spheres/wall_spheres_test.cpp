// Wall spheres on solids of known shape: their depth, their grids, their gaps and how far their envelope
// strays.
#include "geometry/wall_spheres/wall_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/solid/solid_query.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

constexpr double kRadius = 1.5e-4;
constexpr double kSpacing = 1.6 * kRadius;

WallSphereOptions options() {
  WallSphereOptions result;
  result.radius = kRadius;
  return result;
}

/// Diameter of the hole in the middle of four spheres on a square grid.
double square_grid_gap(double spacing_over_radius) {
  return 2 * kRadius * (spacing_over_radius / std::sqrt(2) - 1);
}

/// Every centre is inside, and neither closer to the surface than R nor deeper.
void expect_all_at_depth(const Mesh& mesh, const WallSpheres& spheres) {
  const SolidQuery query(mesh);
  double shallowest = 1;
  double deepest = 0;
  for (const Eigen::Vector3d& centre : spheres.centres) {
    const double depth = -query.signed_distance(centre);
    shallowest = std::min(shallowest, depth);
    deepest = std::max(deepest, depth);
  }
  EXPECT_GE(shallowest, kRadius * (1 - 1e-9));
  EXPECT_NEAR(shallowest, kRadius, 1e-12);
  EXPECT_NEAR(deepest, kRadius, 1e-12);
}

/// The widest place without a sphere along a line of points at depth R: the brute-force answer to "does it
/// leak".
double widest_along(const WallSpheres& spheres, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  double widest = 0;
  for (int i = 0; i <= 400; ++i) {
    const Eigen::Vector3d place = from + i / 400.0 * (to - from);
    double nearest = 1;
    for (const Eigen::Vector3d& centre : spheres.centres)
      nearest = std::min(nearest, (centre - place).norm());
    widest = std::max(widest, nearest);
  }
  return widest;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
    sum += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return sum;
}

TEST(WallSpheres, CoverABoxWithSquareGrids) {
  const Eigen::Vector3d size(0.006, 0.005, 0.004);
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), size);
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  // The inset box carries ceil(length / spacing) intervals a side: the shell of a grid of points.
  Eigen::Vector3d points;
  for (int i = 0; i < 3; ++i) points[i] = std::ceil((size[i] - 2 * kRadius) / kSpacing) + 1;
  const double shell = points.prod() - (points.array() - 2).prod();
  EXPECT_EQ(static_cast<double>(spheres.centres.size()), shell);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
  EXPECT_GT(spheres.largest_gap, 0.5 * square_grid_gap(1.6));
  EXPECT_EQ(spheres.radius, kRadius);
}

TEST(WallSpheres, RowsOfABoxAreStraightAndEven) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.006, 0.005, 0.004));
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  const double intervals = std::ceil((0.006 - 2 * kRadius) / kSpacing);
  const double step = (0.006 - 2 * kRadius) / intervals;
  for (const Eigen::Vector3d& centre : spheres.centres) {
    const double place = (centre.x() - kRadius) / step;
    EXPECT_NEAR(place, std::round(place), 1e-9);
  }
}

TEST(WallSpheres, EnvelopeLiesOnSlantedFaces) {
  const Mesh straight = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.006, 0.005, 0.004));
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Mesh mesh = transformed(straight, turn, Eigen::Vector3d(0.05, -0.03, 0.02));
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_EQ(spheres.centres.size(), make_wall_spheres(straight, options()).centres.size());
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
  const Eigen::Vector3d top = turn * Eigen::Vector3d(0, 0, 0.004) + Eigen::Vector3d(0.05, -0.03, 0.02);
  std::size_t under_top = 0;
  for (const Eigen::Vector3d& centre : spheres.centres) {
    const double depth = (top - centre).dot(turn.col(2));
    if (depth > 1.01 * kRadius) continue;
    EXPECT_NEAR(depth, kRadius, 1e-12);
    ++under_top;
  }
  EXPECT_GT(under_top, 400U);
}

TEST(WallSpheres, DeviationAgreesWithTheSquareGrid) {
  // In the middle of a square of four spheres the envelope is farthest away; at convex edges a rounding is
  // left.
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.02, 0.02, 0.01));
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  // Mean over one square of sqrt(R^2 + r^2) - R, by the midpoint rule.
  double mean = 0;
  const int steps = 200;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double x = 0.8 * kRadius * (i + 0.5) / steps;
      const double y = 0.8 * kRadius * (j + 0.5) / steps;
      mean += (std::sqrt(kRadius * kRadius + x * x + y * y) - kRadius) / (steps * steps);
    }
  EXPECT_NEAR(spheres.mean_deviation, mean, 0.04 * mean);
  // At a corner of the box the sphere is farthest: sqrt(3) R - R; halfway between edge spheres sqrt(2 +
  // 0.8^2) R - R.
  EXPECT_LT(spheres.largest_deviation, (std::sqrt(3) - 1) * kRadius);
  EXPECT_GT(spheres.largest_deviation, (std::sqrt(2) - 1) * kRadius);
}

TEST(WallSpheres, StandInRingsOnACylinder) {
  const Mesh mesh = sample::cylinder(0.004, 0.005, 180);
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
  const double rows = std::ceil((0.005 - 2 * kRadius) / kSpacing);
  const double step = (0.005 - 2 * kRadius) / rows;
  const auto around =
      static_cast<std::size_t>(std::ceil(2 * std::numbers::pi * (0.004 - kRadius) / kSpacing));
  for (int row = 1; row < static_cast<int>(rows); ++row) {
    const double height = kRadius + row * step;
    const auto in_ring = std::count_if(spheres.centres.begin(), spheres.centres.end(),
                                       [&](const auto& c) { return std::abs(c.z() - height) < 1e-12; });
    EXPECT_NEAR(static_cast<double>(in_ring), static_cast<double>(around), 1);
  }
}

TEST(WallSpheres, CloseTheCavityWallOfATube) {
  for (const int facets : {24, 90, 720}) {
    const Mesh mesh = sample::tube(0.003, 0.005, 0.004, facets);
    const WallSpheres spheres = make_wall_spheres(mesh, options());
    expect_all_at_depth(mesh, spheres);
    EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5)) << facets;
    const double count = static_cast<double>(spheres.centres.size()) * kSpacing * kSpacing / area(mesh);
    EXPECT_NEAR(count, 1, 0.15) << facets;
  }
}

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

TEST(WallSpheres, FollowASphereWhateverTheSizeOfItsTriangles) {
  for (const int levels : {1, 3, 5}) {
    const Mesh mesh = sample::sphere(0.003, levels);
    const WallSpheres spheres = make_wall_spheres(mesh, options());
    expect_all_at_depth(mesh, spheres);
    EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-4)) << levels;
    EXPECT_LT(spheres.largest_deviation, 0.6 * kRadius) << levels;
    const double count = static_cast<double>(spheres.centres.size()) * kSpacing * kSpacing / area(mesh);
    EXPECT_NEAR(count, 1, 0.25) << levels;
  }
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
  } catch (const MeshError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("only 0.285 mm thick"), std::string::npos) << message;
    EXPECT_NE(message.find("below 0.1425 mm"), std::string::npos) << message;
  }
}

TEST(WallSpheres, FillAPlateOfExactlyOneSphere) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.005, 0.005, 2 * kRadius));
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
}

TEST(WallSpheres, CoverOnlyWhatPowderReachesAndItsEdge) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.02, 0.02, 0.01));
  WallSphereOptions only_a_patch = options();
  only_a_patch.reachable = [](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    return normal.z() > 0.9 && std::abs(point.x() - 0.01) < 0.003 && std::abs(point.y() - 0.01) < 0.003;
  };
  const WallSpheres spheres = make_wall_spheres(mesh, only_a_patch);
  expect_all_at_depth(mesh, spheres);
  ASSERT_FALSE(spheres.centres.empty());
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-5));
  EXPECT_LT(spheres.centres.size(), 1100U);
  for (const Eigen::Vector3d& centre : spheres.centres) {
    EXPECT_NEAR(centre.z(), 0.01 - kRadius, 1e-12);
    EXPECT_LT((centre.head<2>() - Eigen::Vector2d(0.01, 0.01)).cwiseAbs().maxCoeff(), 0.003 + 2 * kSpacing);
  }
  const double depth = 0.01 - kRadius;
  EXPECT_LE(widest_along(spheres, {0.007, 0.007, depth}, {0.013, 0.007, depth}), 1.1315 * kRadius);
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

TEST(WallSpheres, OfAnUnreachableToolAreNone) {
  WallSphereOptions nothing = options();
  nothing.reachable = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return false; };
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.005, 0.005, 0.0001));
  const WallSpheres spheres = make_wall_spheres(mesh, nothing);
  EXPECT_TRUE(spheres.centres.empty());
  EXPECT_EQ(spheres.largest_gap, 0);
}

TEST(WallSpheres, AreTheSameBitForBitEveryTime) {
  const Mesh mesh = sample::tube(0.003, 0.005, 0.004, 50);
  const WallSpheres one = make_wall_spheres(mesh, options());
  const WallSpheres other = make_wall_spheres(mesh, options());
  ASSERT_EQ(one.centres.size(), other.centres.size());
  for (std::size_t i = 0; i < one.centres.size(); ++i) EXPECT_EQ(one.centres[i], other.centres[i]);
  EXPECT_EQ(one.mean_deviation, other.mean_deviation);
  EXPECT_EQ(one.largest_gap, other.largest_gap);
}

TEST(WallSpheres, TellHowFarTheyAreWithoutEverGoingBack) {
  WallSphereOptions telling = options();
  telling.reachable = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return true; };
  std::vector<double> told;
  telling.tell = [&](double share) { told.push_back(share); };
  const Mesh tube = sample::tube(0.004, 0.006, 0.005, 200);
  const WallSpheres spheres = make_wall_spheres(tube, telling);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.front(), 0);
  EXPECT_DOUBLE_EQ(told.back(), 1);
  telling.tell = nullptr;
  EXPECT_EQ(make_wall_spheres(tube, telling).centres, spheres.centres);
}

TEST(WallSpheres, PredictTheGapOfACoarseGrid) {
  // 8 x 8 x 4 intervals of exactly 3 R between the outermost rows.
  const double side = (8 * 3 + 2) * kRadius;
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(side, side, (4 * 3 + 2) * kRadius));
  WallSphereOptions coarse = options();
  coarse.spacing = 3;
  EXPECT_NEAR(make_wall_spheres(mesh, coarse).largest_gap, square_grid_gap(3), 1e-9 * kRadius);
}

TEST(WallSpheres, OverlappingDenselyLeaveNoGap) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d(0.002, 0.002, 0.002));
  WallSphereOptions dense = options();
  dense.spacing = 1.2;
  EXPECT_EQ(make_wall_spheres(mesh, dense).largest_gap, 0);
}

TEST(WallSpheres, FollowAMeshWithTheRoundingOfSinglePrecision) {
  Mesh mesh = transformed(sample::tube(0.003, 0.005, 0.004, 90),
                          Eigen::AngleAxisd(0.4, Eigen::Vector3d(3, 1, 2).normalized()).toRotationMatrix(),
                          Eigen::Vector3d(0.08, 0.05, 0.03));
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = vertex.cast<float>().cast<double>();
  const WallSpheres spheres = make_wall_spheres(mesh, options());
  expect_all_at_depth(mesh, spheres);
  EXPECT_LE(spheres.largest_gap, square_grid_gap(1.6) * (1 + 1e-3));
}

TEST(WallSpheres, RefuseImpossibleOptions) {
  const Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.005));
  for (const auto& [radius, spacing] : {std::pair(0.0, 1.6), {-1e-4, 1.6}, {1e-4, 0.0}, {1e-4, 1e9}}) {
    WallSphereOptions bad;
    bad.radius = radius;
    bad.spacing = spacing;
    EXPECT_THROW(make_wall_spheres(mesh, bad), MeshError);
  }
}

}  // namespace
}  // namespace diefill::geometry
