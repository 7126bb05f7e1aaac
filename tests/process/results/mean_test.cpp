// Means of samples.
#include "process/results/studies/mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace diefill::results {
namespace {

TEST(Mean, IsTheSumOverTheNumberOfValues) {
  EXPECT_EQ(mean_of(std::vector<double>{1, 2, 6}), 3);
  EXPECT_TRUE(std::isnan(mean_of(std::vector<double>())));
  EXPECT_TRUE(std::isnan(mean_of(std::vector<double>{1, std::nan("")})));
}

TEST(Mean, OfFiniteValuesLeavesOutOthers) {
  EXPECT_EQ(mean_of_finite({1, std::nan(""), 6, INFINITY, 2}), 3);
  EXPECT_TRUE(std::isnan(mean_of_finite({std::nan("")})));
}

}  // namespace
}  // namespace diefill::results
