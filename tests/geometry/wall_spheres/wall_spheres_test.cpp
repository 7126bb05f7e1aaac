// Wall spheres on solids of known shape: their depth, their grids, their gaps and how far their envelope
// strays.
#include "geometry/wall_spheres/wall_spheres.h"

#include <numbers>

#include "tests/geometry/wall_spheres/wall_sphere_support.h"

namespace diefill::geometry {
namespace {

using namespace wall_sphere_tests;

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
  std::vector<double> reported;
  telling.on_progress = [&](double share) { reported.push_back(share); };
  const Mesh tube = sample::tube(0.004, 0.006, 0.005, 200);
  const WallSpheres spheres = make_wall_spheres(tube, telling);
  ASSERT_FALSE(reported.empty());
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GT(reported.front(), 0);
  EXPECT_DOUBLE_EQ(reported.back(), 1);
  telling.on_progress = nullptr;
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
