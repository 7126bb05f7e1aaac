// Size distributions cut into classes: what is kept exactly, how the rest converges, and how grains are
// drawn.
#include "engine/powder/size_classes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace diefill::engine {
namespace {

double moment_of(const std::vector<CutClass>& classes, double power) {
  double sum = 0;
  for (const auto& one : classes) sum += one.number_share * std::pow(one.diameter, power);
  return sum;
}

TEST(CutSizes, KeepNumberAndMassWhateverTheirCount) {
  const auto sizes = SizeDistribution::log_normal(3e-4, 0.5, SizeBasis::mass);
  for (const std::size_t count : {1U, 3U, 32U}) {
    const auto classes = size_classes(sizes, count);
    EXPECT_EQ(classes.size(), count);
    EXPECT_NEAR(moment_of(classes, 0), 1, 1e-12);
    EXPECT_NEAR(moment_of(classes, 3), sizes.moment(3), 1e-12 * sizes.moment(3));
    for (std::size_t k = 1; k < classes.size(); ++k) EXPECT_GT(classes[k].diameter, classes[k - 1].diameter);
  }
}

TEST(CutSizes, OtherMomentsConvergeWithTheSquareOfTheClassWidth) {
  const auto sizes =
      SizeDistribution::log_normal(3e-4, 0.4, SizeBasis::number, {.smallest = 1.5e-4, .largest = 6e-4});
  for (const double power : {1.0, 2.0, 5.0}) {
    const auto error = [&](std::size_t count) {
      return std::abs(moment_of(size_classes(sizes, count), power) / sizes.moment(power) - 1);
    };
    EXPECT_NEAR(error(8) / error(16), 4, 0.5) << power;
    EXPECT_LT(error(32), 1e-3) << power;
  }
}

TEST(CutSizes, StayWithinTheCutOffs) {
  const auto sizes =
      SizeDistribution::log_normal(3e-4, 0.4, SizeBasis::number, {.smallest = 2e-4, .largest = 4e-4});
  const auto classes = size_classes(sizes, 12);
  EXPECT_GT(classes.front().diameter, 2e-4);
  EXPECT_LT(classes.back().diameter, 4e-4);
}

TEST(CutSizes, OfADiscreteDistributionAreItsOwn) {
  const auto sizes = SizeDistribution::discrete({{1e-3, 1}, {5e-4, 1}}, SizeBasis::mass);
  const auto classes = size_classes(sizes, 8);
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].diameter, 5e-4);
  EXPECT_NEAR(classes[0].number_share, 8.0 / 9.0, 1e-15);
  EXPECT_THROW(size_classes(sizes, 1), std::invalid_argument);
  EXPECT_THROW(size_classes(sizes, 0), std::invalid_argument);
}

TEST(DrawnClasses, HaveTheSharesAsNearAsWholeNumbersCome) {
  const auto sizes = SizeDistribution::log_normal(3e-4, 0.4, SizeBasis::number);
  const auto classes = size_classes(sizes, 16);
  for (const std::size_t grains : {7U, 1000U}) {
    const auto counts = class_counts(classes, grains);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), grains);
    for (std::size_t c = 0; c < counts.size(); ++c)
      EXPECT_LE(
          std::abs(static_cast<double>(counts[c]) - classes[c].number_share * static_cast<double>(grains)),
          1);
    const auto drawn = drawn_classes(classes, grains, 5);
    std::vector<std::size_t> found(classes.size());
    for (const auto one : drawn) ++found[one];
    EXPECT_EQ(found, counts);
    EXPECT_EQ(drawn, drawn_classes(classes, grains, 5));
  }
  EXPECT_NE(drawn_classes(classes, 1000, 5), drawn_classes(classes, 1000, 6));
}

}  // namespace
}  // namespace diefill::engine
