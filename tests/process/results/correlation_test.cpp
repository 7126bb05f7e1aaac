// Correlation of paired values, and where it is not determined.
#include "process/results/studies/correlation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::results {
namespace {

TEST(PearsonCorrelation, IsTheCosineOfTheAngleBetweenDeviations) {
  EXPECT_NEAR(pearson_correlation({1, 2, 3}, {10, 20, 30}), 1, 1e-15);
  EXPECT_NEAR(pearson_correlation({1, 2, 3}, {3, 2, 1}), -1, 1e-15);
  // Deviations (-1, 0, 1) and (-1, 1, 0): 1 / (sqrt(2) sqrt(2)).
  EXPECT_NEAR(pearson_correlation({1, 2, 3}, {1, 3, 2}), 0.5, 1e-15);
  // Small on a large mean, far above rounding.
  EXPECT_NEAR(pearson_correlation({1e6, 1e6 + 1e-3, 1e6 + 2e-3}, {1, 2, 3}), 1, 1e-6);
}

TEST(PearsonCorrelation, OfConstantValuesIsNotDetermined) {
  for (const double value : {0.0, 0.1, 0.3, 15.1, -7e5})
    for (const std::size_t count : {3, 7, 29, 1000}) {
      std::vector<double> rising;
      for (std::size_t k = 0; k < count; ++k) rising.push_back(0.1 * static_cast<double>(k));
      const std::vector<double> constant(count, value);
      EXPECT_TRUE(std::isnan(pearson_correlation(constant, rising))) << value << ' ' << count;
      EXPECT_TRUE(std::isnan(pearson_correlation(rising, constant))) << value << ' ' << count;
    }
  EXPECT_TRUE(std::isnan(pearson_correlation({1, 2}, {1, 2})));
}

}  // namespace
}  // namespace diefill::results
