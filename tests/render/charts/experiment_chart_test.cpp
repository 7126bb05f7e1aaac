#include "render/charts/experiment_chart.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::render {
namespace {

results::ExperimentChart from_zero(const std::vector<double>& values) {
  results::ExperimentChart chart;
  chart.y.lower = 0;
  chart.series.push_back({.name = "here", .x = {1, 2}, .y = values});
  return chart;
}

TEST(ExperimentChart, BeginsAtZeroAsItSays) {
  EXPECT_EQ(chart_of(from_zero({0.5, 1})).y.lower, 0);
}

TEST(ExperimentChart, CutsOffNoNegativeValueOfAnAxisFromZero) {
  EXPECT_TRUE(std::isnan(chart_of(from_zero({0.5, -1})).y.lower));
}

TEST(ExperimentChart, KeepsARangeThatDoesNotBeginAtZero) {
  auto chart = from_zero({-3, 1});
  chart.y.lower = -2;
  EXPECT_EQ(chart_of(chart).y.lower, -2);
}

}  // namespace
}  // namespace diefill::render
