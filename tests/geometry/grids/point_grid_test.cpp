// Questions to the grid of points have the answers that looking at every point gives.
#include "geometry/grids/point_grid.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace diefill::geometry {
namespace {

constexpr double kCell = 0.3;

class PointGridAnswers : public testing::TestWithParam<double> {
 protected:
  PointGridAnswers() {
    // On a lattice as fine as the questions' places, so that many are equally near, and on cells' borders.
    for (int i = 0; i < 3000; ++i) grid_.insert(place());
  }
  Eigen::Vector3d place() { return {0.1 * step_(random_), 0.1 * step_(random_), 0.1 * step_(random_)}; }

  /// The first of the nearest points within `radius`, by looking at all.
  std::size_t nearest_of_all(const Eigen::Vector3d& place, double radius) const {
    std::size_t best = PointGrid::kNone;
    double best_squared = radius * radius;
    for (std::size_t i = 0; i < grid_.points().size(); ++i) {
      const double squared = (grid_.points()[i] - place).squaredNorm();
      if (squared < best_squared || (squared == best_squared && best == PointGrid::kNone)) {
        best = i;
        best_squared = squared;
      }
    }
    return best;
  }

  std::mt19937 random_{1};
  std::uniform_int_distribution<int> step_{-20, 20};
  PointGrid grid_{kCell};
};

TEST_P(PointGridAnswers, NearestIsTheFirstOfTheNearestOfAll) {
  for (int question = 0; question < 500; ++question) {
    const Eigen::Vector3d asked = place();
    EXPECT_EQ(grid_.nearest_within(asked, GetParam()), nearest_of_all(asked, GetParam()));
  }
}

TEST_P(PointGridAnswers, AnyIsThereWhereANearestIs) {
  int found = 0;
  for (int question = 0; question < 500; ++question) {
    const Eigen::Vector3d asked = place() + Eigen::Vector3d(0.03, 0.04, 0);
    const bool any = grid_.any_within(asked, GetParam());
    EXPECT_EQ(any, nearest_of_all(asked, GetParam()) != PointGrid::kNone);
    found += any;
  }
  if (GetParam() > 1) {
    EXPECT_EQ(found, 500);
  }
}

TEST_P(PointGridAnswers, EachIsVisitedOnce) {
  const Eigen::Vector3d asked = place();
  std::vector<int> visits(grid_.points().size(), 0);
  grid_.for_each_within(asked, GetParam(), [&](std::size_t index) { ++visits[index]; });
  for (std::size_t i = 0; i < visits.size(); ++i)
    EXPECT_EQ(visits[i], (grid_.points()[i] - asked).squaredNorm() <= GetParam() * GetParam() ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Radii, PointGridAnswers, testing::Values(0.0, 0.05, 0.1, 0.25, 0.3, 0.7, 4.0));

}  // namespace
}  // namespace diefill::geometry
