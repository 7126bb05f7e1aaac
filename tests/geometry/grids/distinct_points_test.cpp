#include "geometry/grids/distinct_points.h"

#include <gtest/gtest.h>

#include <random>

namespace diefill::geometry {
namespace {

std::vector<Eigen::Vector3d> scattered(std::size_t count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& point : points) point = {place(random), place(random), place(random)};
  return points;
}

double least_distance(const std::vector<Eigen::Vector3d>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
  return least;
}

TEST(SurelyDistinct, IsTrueUpToTheLeastDistanceOfAllPairs) {
  const auto points = scattered(3000);
  const double least = least_distance(points);
  EXPECT_TRUE(surely_distinct(points, 0.999 * least));
  EXPECT_FALSE(surely_distinct(points, 1.001 * least));
}

TEST(SurelyDistinct, SeesOneCloseCopyAmongMany) {
  auto points = scattered(100000);
  const double distance = 1e-7;
  ASSERT_TRUE(surely_distinct(points, distance));
  points.push_back(points[31415] + Eigen::Vector3d(0, 0.9 * distance, 0));
  EXPECT_FALSE(surely_distinct(points, distance));
}

TEST(SurelyDistinct, SeesEqualPoints) {
  EXPECT_FALSE(surely_distinct({{1, 2, 3}, {3, 2, 1}, {1, 2, 3}}, 0));
}

TEST(SurelyDistinct, HoldsForAPlaneOfPoints) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) points.emplace_back(0.01 * i, 0.01 * j, 7);
  EXPECT_TRUE(surely_distinct(points, 0.0099));
  EXPECT_FALSE(surely_distinct(points, 0.0101));
}

TEST(SurelyDistinct, NoPointsAndOneAre) {
  EXPECT_TRUE(surely_distinct({}, 1));
  EXPECT_TRUE(surely_distinct({{0, 0, 0}}, 1));
}

}  // namespace
}  // namespace diefill::geometry
