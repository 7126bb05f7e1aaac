// Scatter, intervals and verdicts against numbers worked out by hand and published tables.
#include <gtest/gtest.h>

#include <cmath>

#include "process/compare/collect.h"
#include "process/compare/compared_fields.h"
#include "process/compare/statistics.h"
#include "process/results/places_without_value.h"

namespace diefill::process {
namespace {

TEST(Statistics, MeanAndScatterOfASample) {
  const Sample sample = sample_of({2, 4, 4, 4, 5, 5, 7, 9, std::nan("")});
  EXPECT_EQ(sample.count, 8U);
  EXPECT_NEAR(sample.mean, 5, 1e-14);
  EXPECT_NEAR(sample.scatter, std::sqrt(32.0 / 7), 1e-14);
  EXPECT_TRUE(std::isnan(sample_of({3}).scatter));
  EXPECT_TRUE(std::isnan(sample_of({}).mean));
}

TEST(Statistics, AnglesComeRoundAgain) {
  const Sample sample = sample_of({350, 10, 0}, 360);
  EXPECT_NEAR(std::remainder(sample.mean, 360), 0, 1e-12);
  EXPECT_NEAR(sample.scatter, 10, 1e-12);
  EXPECT_NEAR(difference(350, 20, 360), 30, 1e-12);
  EXPECT_NEAR(difference(20, 350, 360), -30, 1e-12);
  EXPECT_NEAR(difference(170, 5, 180), 15, 1e-12);
}

// Equal variances and sizes: Welch's degrees of freedom are 2 n - 2, and t_{0.975, 4} = 2.776445.
TEST(Statistics, WelchIntervalOfEqualSpreads) {
  const Sample a = sample_of({1, 2, 3}), b = sample_of({11, 12, 13});
  EXPECT_NEAR(welch_half_width(a, b), 2.776445 * std::sqrt(2.0 / 3), 1e-6);
}

// One mean without spread: nu = n - 1 of the other, t_{0.975, 2} = 4.302653.
TEST(Statistics, WelchIntervalOfOneSpreadAlone) {
  const Sample a = sample_of({5, 5, 5}), b = sample_of({1, 2, 3});
  EXPECT_NEAR(welch_half_width(a, b), 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_EQ(welch_half_width(a, sample_of({6, 6})), 0);
  EXPECT_TRUE(std::isnan(welch_half_width(a, sample_of({6}))));
}

results::ComparedRun run_of(const std::string& variant, std::uint64_t seed, double mass, double azimuth) {
  results::ComparedRun run;
  run.variant = variant;
  run.seed = seed;
  run.values = {{"filled_mass_kg", mass}, {"solid_fraction_harmonic_1_azimuth_deg", azimuth}};
  return run;
}

TEST(Verdicts, TellDifferencesFromScatter) {
  using results::Verdict;
  const auto measures =
      compare_runs({"first", "same", "heavier", "single", "none"},
                   {run_of("first", 1, 10, 359), run_of("first", 2, 11, 1), run_of("first", 3, 12, 0),
                    run_of("same", 1, 11, 2), run_of("same", 2, 12, 358), run_of("same", 3, 13, 3),
                    run_of("heavier", 1, 20, 40), run_of("heavier", 2, 21, 41), run_of("heavier", 3, 22, 42),
                    run_of("single", 1, 50, 0)});
  ASSERT_EQ(measures.size(), 2U);  // what no run has is left out
  const auto& mass = measures[0].values;
  EXPECT_EQ(mass[0].verdict, Verdict::reference);
  EXPECT_EQ(mass[1].verdict, Verdict::none);
  EXPECT_NEAR(mass[1].difference, 1, 1e-12);
  EXPECT_EQ(mass[2].verdict, Verdict::different);
  EXPECT_NEAR(mass[2].interval, 2.776445 * std::sqrt(2.0 / 3), 1e-6);
  EXPECT_EQ(mass[3].verdict, Verdict::scatter_unknown);
  EXPECT_EQ(mass[4].verdict, Verdict::missing);
  const auto& azimuth = measures[1].values;
  EXPECT_EQ(azimuth[1].verdict, Verdict::none);
  EXPECT_NEAR(azimuth[2].difference, 41, 1e-9);
  EXPECT_EQ(azimuth[2].verdict, Verdict::different);
}

// Times that are sums of others differ by their rounding alone.
TEST(Verdicts, RoundingIsNoDifference) {
  using results::Verdict;
  const double rounded = 0.1 + 0.2;  // 0.3 + 5.6e-17
  const auto measures = compare_runs(
      {"first", "single", "second"},
      {run_of("first", 1, 0.3, 0), run_of("first", 2, rounded, 0), run_of("single", 1, rounded, 1e-14),
       run_of("second", 1, rounded, 0), run_of("second", 2, rounded, 0)});
  for (const auto& measure : measures) {
    EXPECT_EQ(measure.values[0].scatter, 0) << measure.key;
    EXPECT_EQ(measure.values[1].difference, 0) << measure.key;
    EXPECT_EQ(measure.values[2].difference, 0) << measure.key;
    EXPECT_EQ(measure.values[2].verdict, Verdict::none) << measure.key;
  }
}

TEST(MeanField, IsAtTheNodesOfTheFirstWhereHalfOfAllHavePowder) {
  results::Field2D low{"solid fraction", "azimuth", "deg", "height", "mm", {0, 180, 360}, {0, 1}, {}, 1e-3};
  low.value = {0.2, 0.3, 0.4, 0.5, std::nan(""), 0.7};
  results::Field2D high = low;
  high.second = {0, 1, 2};
  high.value = {0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1, 1};
  const auto mean = mean_field({low, high});
  EXPECT_EQ(mean.second, low.second);
  ASSERT_EQ(mean.value.size(), 6U);
  EXPECT_NEAR(mean.value[1], 0.4, 1e-15);
  EXPECT_NEAR(mean.value[4], 0.8, 1e-15);  // powder in one of two
  EXPECT_TRUE(std::isnan(mean_field({low, low, high}).value[4]));
  EXPECT_NEAR(mean.value[5], 0.8, 1e-15);
  const auto other = mean_field({high, low});
  EXPECT_EQ(other.second, high.second);
  EXPECT_NEAR(other.value[5], 0.8, 1e-15);
  EXPECT_NEAR(other.value[6], 1, 1e-15);  // above what the second one has
  EXPECT_TRUE(std::isnan(mean_field({high, low, low}).value[6]));
  results::Field2D shifted = high;  // other nodes: halfway between those of the first
  shifted.second = {-0.5, 0.5, 1.5};
  EXPECT_NEAR(mean_field({low, shifted}).value[0], (0.2 + 0.5 * (0.4 + 0.7)) / 2, 1e-15);
  EXPECT_TRUE(mean_field({}).value.empty());
}

TEST(MeanField, KnowsPowderWithoutValueFromNoPowder) {
  results::Field2D one{"solid fraction", "azimuth", "deg", "height", "mm", {0, 180, 360}, {0, 1}, {}, 1e-3};
  one.value = {results::unvalued_powder(), results::unvalued_powder(), 0.4, 0.5, std::nan(""), 0.7};
  results::Field2D two = one;
  two.value = {results::unvalued_powder(), 0.3, 0.4, 0.5, std::nan(""), 0.7};
  const auto mean = mean_field({one, two});
  EXPECT_TRUE(results::is_unvalued_powder(mean.value[0]));
  EXPECT_NEAR(mean.value[1], 0.3, 1e-15);
  EXPECT_TRUE(std::isnan(mean.value[4]));
  EXPECT_FALSE(results::is_unvalued_powder(mean.value[4]));
}

}  // namespace
}  // namespace diefill::process
