#include "process/laboratory/published/charts_over_seeds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process::laboratory {
namespace {

using results::ExperimentChart;
using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

ExperimentChart chart_with(const std::vector<ExperimentSeries>& series,
                           const std::string& name = "discharge") {
  ExperimentChart chart;
  chart.name = name;
  chart.subtitle = "Model D";
  chart.series = series;
  return chart;
}

ExperimentSeries curve(const std::vector<double>& x, const std::vector<double>& y,
                       Role role = Role::measured) {
  return {.name = "10 mm", .role = role, .x = x, .y = y};
}

TEST(ChartsOverSeeds, CurvesAtTheSamePlacesBecomeTheirMeanWithTheStandardDeviation) {
  const auto charts = charts_over_seeds({{chart_with({curve({1, 2}, {4, 10})})},
                                         {chart_with({curve({1, 2}, {6, 10})})},
                                         {chart_with({curve({1, 2}, {5, 13})})}});
  ASSERT_EQ(charts.size(), 1U);
  ASSERT_EQ(charts[0].series.size(), 1U);
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{1, 2}));
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{5, 11}));
  ASSERT_EQ(charts[0].series[0].y_scatter.size(), 2U);
  EXPECT_DOUBLE_EQ(charts[0].series[0].y_scatter[0], 1);
  EXPECT_DOUBLE_EQ(charts[0].series[0].y_scatter[1], std::sqrt(3.0));
  EXPECT_EQ(charts[0].subtitle, "Model D; mean and standard deviation over 3 seeds");
}

TEST(ChartsOverSeeds, PlacesWhoseRunsAreMissingWithASeedHaveTheMeanOfTheOthers) {
  const auto charts =
      charts_over_seeds({{chart_with({curve({2}, {4})})}, {chart_with({curve({1, 2, 3}, {7, 6, kNone})})}});
  ASSERT_EQ(charts.size(), 1U);
  const ExperimentSeries& mean = charts[0].series[0];
  EXPECT_EQ(mean.x, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(mean.y[0], 7);
  EXPECT_EQ(mean.y[1], 5);
  EXPECT_TRUE(std::isnan(mean.y[2]));
  EXPECT_EQ(mean.y_scatter[0], 0);
}

TEST(ChartsOverSeeds, CurvesAtTheirOwnPlacesAreThoseOfTheFirstSeed) {
  const auto charts =
      charts_over_seeds({{chart_with({curve({1, 2}, {4, 10})})}, {chart_with({curve({1.1, 2}, {6, 10})})}});
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{1, 2}));
  EXPECT_TRUE(charts[0].series[0].y_scatter.empty());
  EXPECT_EQ(charts[0].subtitle, "Model D; curves of the first of 2 seeds");
}

TEST(ChartsOverSeeds, CyclesThatPassAPlaceTwiceAreNotAveraged) {
  const auto charts = charts_over_seeds(
      {{chart_with({curve({1, 2, 1}, {4, 10, 5})})}, {chart_with({curve({1, 2, 1}, {6, 10, 7})})}});
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{4, 10, 5}));
  EXPECT_EQ(charts[0].subtitle, "Model D; curves of the first of 2 seeds");
}

TEST(ChartsOverSeeds, ChartsOfEventsAreThoseOfTheFirstSeedEvenAtCommonPlaces) {
  auto first = chart_with({curve({1, 2}, {4, 10})});
  first.first_seed_only = true;
  auto second = chart_with({curve({1, 2}, {6, 11})});
  second.first_seed_only = true;
  const auto charts = charts_over_seeds({{first}, {second}});
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{4, 10}));
  EXPECT_TRUE(charts[0].series[0].y_scatter.empty());
  EXPECT_EQ(charts[0].subtitle, "Model D; first of 2 seeds");
}

TEST(ChartsOverSeeds, PointsOfAllSeedsAreDrawn) {
  const auto charts = charts_over_seeds({{chart_with({curve({1, 2}, {4, 10}, Role::points)})},
                                         {chart_with({curve({1, 2}, {6, 11}, Role::points)})}});
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{1, 2, 1, 2}));
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{4, 10, 6, 11}));
  EXPECT_EQ(charts[0].subtitle, "Model D; points of 2 seeds");
}

TEST(ChartsOverSeeds, WhatIsPublishedStandsOnceAndSeriesWithTheSameNameStayApart) {
  const ExperimentSeries published{.name = "published", .role = Role::published, .x = {1}, .y = {5}};
  const auto one = chart_with({published, curve({1}, {4}), curve({1}, {40})});
  const auto other = chart_with({published, curve({1}, {6}), curve({1}, {60})});
  const auto charts = charts_over_seeds({{one}, {other}});
  ASSERT_EQ(charts[0].series.size(), 3U);
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{5}));
  EXPECT_EQ(charts[0].series[1].y, (std::vector<double>{5}));
  EXPECT_EQ(charts[0].series[2].y, (std::vector<double>{50}));
}

TEST(ChartsOverSeeds, OneSeedIsNamedAndSeriesWithoutValuesAreLeftOut) {
  const auto charts = charts_over_seeds({{chart_with({curve({1}, {4}), curve({1, 2}, {kNone, kNone})})}});
  ASSERT_EQ(charts[0].series.size(), 1U);
  EXPECT_EQ(charts[0].subtitle, "Model D; one seed");
}

TEST(ChartsOverSeeds, ChartsOfOneSeedAloneAreKept) {
  const auto charts = charts_over_seeds(
      {{chart_with({curve({1}, {4})}, "first")}, {chart_with({curve({1}, {6})}, "second")}});
  ASSERT_EQ(charts.size(), 2U);
  EXPECT_EQ(charts[0].name, "first");
  EXPECT_EQ(charts[1].subtitle, "Model D; one seed");
}

TEST(ChartsOverSeeds, ANoteThatDiffersIsSaidToBeOfTheFirstSeed) {
  auto one = chart_with({curve({1}, {4})}), other = one;
  one.note = "Fitted offset: 1.2 d";
  other.note = "Fitted offset: 1.4 d";
  EXPECT_EQ(charts_over_seeds({{one}, {other}})[0].note, "First seed: Fitted offset: 1.2 d");
  EXPECT_EQ(charts_over_seeds({{one}, {one}})[0].note, "Fitted offset: 1.2 d");
}

}  // namespace
}  // namespace diefill::process::laboratory
