// What is kept of a grid of points answers as the grid itself does.
#include "geometry/grids/near_points.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace diefill::geometry {
namespace {

constexpr double kRadius = 0.3;

/// Cubes smaller and larger than the radius.
class NearPointsAnswer : public testing::TestWithParam<double> {
 protected:
  Eigen::Vector3d somewhere() { return {0.1 * step_(random_), 0.1 * step_(random_), 0.1 * step_(random_)}; }

  std::mt19937 random_{1};
  std::uniform_int_distribution<int> step_{-20, 20};
  PointGrid grid_{0.4};
};

TEST_P(NearPointsAnswer, AsTheGridDoesWhileItGrows) {
  NearPoints near(grid_, kRadius, GetParam());
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (int question = 0; question < 4000; ++question) {
    if (question % 3 == 0) grid_.insert(somewhere());
    // Mostly a small step on, as from one sample to the next; radii within and beyond what is kept.
    place = question % 50 == 0 ? somewhere() : Eigen::Vector3d(place + 0.3 * somewhere() / 2);
    const double radius = 0.1 * (question % 5);
    EXPECT_EQ(near.nearest_within(place, radius), grid_.nearest_within(place, radius));
    EXPECT_EQ(near.any_within(place, radius), grid_.any_within(place, radius));
    std::set<std::size_t> expected, met;
    grid_.for_each_within(place, radius, [&](std::size_t index) { expected.insert(index); });
    near.for_each_within(place, radius, [&](std::size_t index, double squared) {
      EXPECT_TRUE(met.insert(index).second);
      EXPECT_EQ(squared, (grid_.points()[index] - place).squaredNorm());
    });
    EXPECT_EQ(met, expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Edges, NearPointsAnswer, testing::Values(0.05, 0.3, 1.0));

}  // namespace
}  // namespace diefill::geometry
