// The nearest triangle, against looking at all of them.
#include "geometry/mesh/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace diefill::geometry {
namespace {

std::vector<Corners> scattered(std::size_t count, const Eigen::Vector3d& about, double size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Corners> triangles(count);
  for (Corners& corners : triangles) {
    const Eigen::Vector3d place = about + 0.02 * Eigen::Vector3d(any(random), any(random), any(random));
    for (auto& corner : corners)
      corner = place + size * Eigen::Vector3d(any(random), any(random), any(random));
  }
  return triangles;
}

TriangleTree tree_of(const std::vector<Corners>& triangles) {
  return {triangles.size(), [&](std::size_t k) { return triangles[k]; }};
}

/// First of the nearest triangles, and m^2 to it.
std::pair<std::size_t, double> nearest_of(const std::vector<Corners>& triangles,
                                          const Eigen::Vector3d& point) {
  std::pair<std::size_t, double> nearest{0, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const double distance = (closest_point(triangles[k], point).point - point).squaredNorm();
    if (distance < nearest.second) nearest = {k, distance};
  }
  return nearest;
}

void expect_nearest(const std::vector<Corners>& triangles, const std::vector<Eigen::Vector3d>& points) {
  const TriangleTree tree = tree_of(triangles);
  for (const auto& point : points) {
    const auto [triangle, distance] = nearest_of(triangles, point);
    for (const double guess :
         {0.5 * std::sqrt(distance), std::sqrt(distance), 3 * std::sqrt(distance), 1.0}) {
      const TriangleTree::Hit hit = tree.nearest(point, guess);
      ASSERT_EQ(hit.triangle, triangle);
      ASSERT_EQ(hit.distance_squared, distance);
    }
    ASSERT_EQ(tree.nearest(point).triangle, triangle);
  }
}

std::vector<Eigen::Vector3d> points_about(const Eigen::Vector3d& middle, double reach) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Eigen::Vector3d> points(300);
  for (auto& point : points) point = middle + reach * Eigen::Vector3d(any(random), any(random), any(random));
  return points;
}

TEST(TriangleTree, FindsTheNearestOfAll) {
  expect_nearest(scattered(2000, {0, 0, 0}, 0.002), points_about({0, 0, 0}, 0.03));
}

// Single precision resolves 60 nm at 1 m: triangles there lie a few of these apart.
TEST(TriangleTree, FindsItAmongTrianglesThatSinglePrecisionCannotTellApart) {
  std::vector<Corners> layers;
  for (int k = 0; k < 200; ++k) {
    const double z = 1 + 2e-9 * k;
    layers.push_back(
        {Eigen::Vector3d(0.9, 0.9, z), Eigen::Vector3d(1.1, 0.9, z), Eigen::Vector3d(1, 1.1, z)});
  }
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < 100; ++k) points.emplace_back(1, 1, 1 + 1e-9 * k * 3);
  for (int k = 0; k < 100; ++k) points.emplace_back(1, 1, 2 + 0.1 * k);
  expect_nearest(layers, points);
}

TEST(TriangleTree, FindsItFromFarAway) {
  expect_nearest(scattered(500, {0.1, -0.2, 0.3}, 0.001), points_about({5, -3, 2}, 1));
}

TEST(TriangleTree, TakesTheFirstOfThoseEquallyNearAndSaysThatItIsNotAlone) {
  const Corners one = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e-3, 0, 0), Eigen::Vector3d(0, 1e-3, 0)};
  Corners far = one;
  for (auto& corner : far) corner.z() += 0.01;
  const TriangleTree::Hit twice = tree_of({far, one, one, far, one}).nearest({2e-4, 2e-4, 1e-4});
  EXPECT_EQ(twice.triangle, 1U);
  EXPECT_FALSE(twice.alone);
  EXPECT_TRUE(tree_of({far, one, far}).nearest({2e-4, 2e-4, 1e-4}).alone);
}

TEST(TriangleTree, PassesOverTrianglesWithoutArea) {
  const Corners good = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e-3, 0, 0), Eigen::Vector3d(0, 1e-3, 0)};
  const Eigen::Vector3d point(1e-4, 1e-4, 2e-4);
  const Corners flat = {point, point, point};
  const TriangleTree::Hit hit = tree_of({flat, good, flat}).nearest(point + Eigen::Vector3d(1e-5, 0, 0));
  EXPECT_TRUE(std::isfinite(hit.distance_squared));
}

}  // namespace
}  // namespace diefill::geometry
