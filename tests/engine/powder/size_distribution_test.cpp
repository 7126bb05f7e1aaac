// Size distributions: closed forms of moments and quantiles, cut-offs, drawing.
#include "engine/powder/size_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace diefill::engine {
namespace {

TEST(SingleSize, IsAlwaysDrawn) {
  const auto sizes = SizeDistribution::single(5e-4);
  for (const double uniform : {0.0, 0.3, 0.999999}) EXPECT_EQ(sizes.sample(uniform), 5e-4);
  EXPECT_DOUBLE_EQ(sizes.mean_mass(1000), 1000 * std::numbers::pi / 6 * 1.25e-10);
  EXPECT_EQ(sizes.fraction_below(4.9e-4, SizeBasis::number), 0);
  EXPECT_EQ(sizes.fraction_below(5e-4, SizeBasis::mass), 1);
}

TEST(SizeClasses, OfEqualMassHaveEightTimesAsManyHalfSizedGrains) {
  // Hu 2024, chapter 5: 0.5 mm and 1 mm grains, masses 1 : 1.
  const auto sizes = SizeDistribution::discrete({{1e-3, 1}, {5e-4, 1}}, SizeBasis::mass);
  EXPECT_NEAR(sizes.fraction_below(5e-4, SizeBasis::number), 8.0 / 9.0, 1e-15);
  EXPECT_NEAR(sizes.fraction_below(5e-4, SizeBasis::mass), 0.5, 1e-15);
  EXPECT_EQ(sizes.sample(0.888), 5e-4);
  EXPECT_EQ(sizes.sample(0.889), 1e-3);
  EXPECT_EQ(sizes.quantile(0.49, SizeBasis::mass), 5e-4);
  EXPECT_EQ(sizes.quantile(0.51, SizeBasis::mass), 1e-3);
  EXPECT_NEAR(sizes.mean_diameter(), (8 * 5e-4 + 1e-3) / 9, 1e-18);
}

TEST(SizeClasses, ByMassKeepTheirSharesOfMass) {
  const std::vector<SizeClass> classes = {{0.6, 0.15}, {0.8, 0.25}, {1.0, 0.30}, {1.2, 0.20}, {1.5, 0.10}};
  const auto sizes = SizeDistribution::discrete(classes, SizeBasis::mass);
  double sum = 0;
  for (const auto& one : classes) {
    sum += one.share;
    EXPECT_NEAR(sizes.fraction_below(one.diameter, SizeBasis::mass), sum, 1e-14);
  }
  double cubes = 0;
  for (const auto& one : classes) cubes += one.share / std::pow(one.diameter, 3);
  EXPECT_NEAR(sizes.moment(3), 1 / cubes, 1e-14);  // mean mass = mass over number
}

TEST(SizeClasses, AreCutAndRefused) {
  const auto sizes =
      SizeDistribution::discrete({{1, 0.5}, {2, 0.3}, {3, 0.2}}, SizeBasis::number, {.smallest = 1.5});
  EXPECT_NEAR(sizes.fraction_below(2, SizeBasis::number), 0.6, 1e-15);
  EXPECT_EQ(sizes.range().smallest, 2);
  EXPECT_THROW(SizeDistribution::discrete({}, SizeBasis::number), std::invalid_argument);
  EXPECT_THROW(SizeDistribution::discrete({{1, -1}}, SizeBasis::number), std::invalid_argument);
  EXPECT_THROW(SizeDistribution::discrete({{1, 1}}, SizeBasis::number, {.largest = 0.5}),
               std::invalid_argument);
}

TEST(LogNormalSizes, HaveTheMomentsOfTheClosedForm) {
  const double median = 3e-4, sigma = 0.4;
  const auto sizes = SizeDistribution::log_normal(median, sigma, SizeBasis::number);
  for (const double power : {1.0, 2.0, 3.0, 4.0}) {
    const double expected = std::pow(median, power) * std::exp(0.5 * power * power * sigma * sigma);
    EXPECT_NEAR(sizes.moment(power), expected, 1e-12 * expected);
  }
  EXPECT_NEAR(sizes.quantile(0.5, SizeBasis::number), median, 1e-14 * median);
  EXPECT_NEAR(sizes.quantile(0.8413447460685429, SizeBasis::number), median * std::exp(sigma),
              1e-12 * median);
  EXPECT_NEAR(sizes.quantile(0.5, SizeBasis::mass), median * std::exp(3 * sigma * sigma), 1e-12 * median);
}

TEST(LogNormalSizes, ByMassHaveTheGivenMassMedian) {
  const auto sizes = SizeDistribution::log_normal(3e-4, 0.4, SizeBasis::mass);
  EXPECT_NEAR(sizes.quantile(0.5, SizeBasis::mass), 3e-4, 1e-16);
  EXPECT_NEAR(sizes.quantile(0.5, SizeBasis::number), 3e-4 * std::exp(-3 * 0.16), 1e-16);
}

TEST(LogNormalSizes, OfMeanHaveHusMeanAndDeviation) {
  for (const double spread : {0.2, 0.4, 0.8}) {
    const auto sizes = SizeDistribution::log_normal_of_mean(1e-3, spread * 1e-3);
    EXPECT_NEAR(sizes.mean_diameter(), 1e-3, 1e-15);
    const double deviation = std::sqrt(sizes.moment(2) - 1e-6);
    EXPECT_NEAR(deviation, spread * 1e-3, 1e-12);
  }
}

TEST(LogNormalSizes, KeepToTheirCutOffs) {
  const SizeCutOffs cut_offs{.smallest = 2e-4, .largest = 6e-4};
  const auto sizes = SizeDistribution::log_normal(3e-4, 0.4, SizeBasis::number, cut_offs);
  EXPECT_DOUBLE_EQ(sizes.sample(0.0), 2e-4);
  EXPECT_LE(sizes.sample(1.0), 6e-4);
  EXPECT_EQ(sizes.fraction_below(1e-4, SizeBasis::number), 0);
  EXPECT_NEAR(sizes.fraction_below(6e-4, SizeBasis::mass), 1, 1e-15);
  // Moments against the mean over equally likely sizes.
  double sum = 0;
  constexpr int kCount = 20000;
  for (int k = 0; k < kCount; ++k) sum += std::pow(sizes.sample((k + 0.5) / kCount), 3);
  EXPECT_NEAR(sum / kCount, sizes.moment(3), 1e-6 * sizes.moment(3));
  for (const auto basis : {SizeBasis::number, SizeBasis::mass})
    for (const double fraction : {0.01, 0.3, 0.99})
      EXPECT_NEAR(sizes.fraction_below(sizes.quantile(fraction, basis), basis), fraction, 1e-12);
}

TEST(LogNormalSizes, RefuseWhatLeavesNothing) {
  EXPECT_THROW(SizeDistribution::log_normal(-1, 0.4, SizeBasis::number), std::invalid_argument);
  EXPECT_THROW(SizeDistribution::log_normal(1, 0, SizeBasis::number), std::invalid_argument);
  EXPECT_THROW(SizeDistribution::log_normal(1, 0.4, SizeBasis::number, {.smallest = 2, .largest = 1}),
               std::invalid_argument);
  EXPECT_THROW(SizeDistribution::log_normal(1, 0.01, SizeBasis::number, {.smallest = 2}),
               std::invalid_argument);
}

TEST(SizeDrawing, DependsOnTheSeedAloneAndHasTheRightMean) {
  const auto sizes =
      SizeDistribution::log_normal(3e-4, 0.3, SizeBasis::mass, {.smallest = 1e-4, .largest = 1e-3});
  const auto drawn = sizes.sample(20000, 7);
  EXPECT_EQ(drawn, sizes.sample(20000, 7));
  EXPECT_NE(drawn, sizes.sample(20000, 8));
  double mass = 0, mass_below = 0;
  for (const double diameter : drawn) {
    mass += std::pow(diameter, 3);
    if (diameter < 3e-4) mass_below += std::pow(diameter, 3);
  }
  EXPECT_NEAR(mass / 20000, sizes.moment(3), 0.04 * sizes.moment(3));
  EXPECT_NEAR(mass_below / mass, sizes.fraction_below(3e-4, SizeBasis::mass), 0.02);
}

TEST(SizeScaling, KeepsSharesAndScalesDiameters) {
  const auto fine =
      SizeDistribution::log_normal(3e-4, 0.4, SizeBasis::number, {.smallest = 2e-4, .largest = 6e-4});
  const auto coarse = fine.scaled(4);
  for (const double uniform : {0.0, 0.2, 0.7, 0.999})
    EXPECT_NEAR(coarse.sample(uniform), 4 * fine.sample(uniform), 1e-15);
  EXPECT_NEAR(coarse.mean_mass(1000), 64 * fine.mean_mass(1000), 1e-12 * coarse.mean_mass(1000));
  const auto classes = SizeDistribution::discrete({{1, 1}, {2, 1}}, SizeBasis::mass);
  EXPECT_NEAR(classes.scaled(3).moment(3), 27 * classes.moment(3), 1e-12);
}

}  // namespace
}  // namespace diefill::engine
