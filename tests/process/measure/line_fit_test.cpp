// Lines of least squares.
#include "process/measure/figures/line_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process {
namespace {

TEST(LineFit, GivesTheLineThatPointsLieOn) {
  const FittedLine line = fit_line({1e6, 1e6 + 1, 1e6 + 4}, {7, 9, 15});
  EXPECT_NEAR(line.slope, 2, 1e-9);
  EXPECT_NEAR(line.at(1e6 + 2), 11, 1e-9);
  EXPECT_NEAR(line.r_squared, 1, 1e-12);
}

TEST(LineFit, LeavesResidualsThatBelongToNoLine) {
  const std::vector<double> x = {0, 1, 2, 3}, y = {0.3, 1.9, 3.2, 3.1};
  const FittedLine line = fit_line(x, y);
  double sum = 0, moment = 0, left = 0, all = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double residual = y[k] - line.at(x[k]);
    sum += residual, moment += residual * x[k], left += residual * residual;
    all += std::pow(y[k] - (0.3 + 1.9 + 3.2 + 3.1) / 4, 2);
  }
  EXPECT_NEAR(sum, 0, 1e-12);
  EXPECT_NEAR(moment, 0, 1e-12);
  EXPECT_NEAR(line.r_squared, 1 - left / all, 1e-12);
}

TEST(LineFit, IsUnknownFromOnePlaceOnly) {
  EXPECT_TRUE(std::isnan(fit_line({2}, {1}).slope));
  EXPECT_TRUE(std::isnan(fit_line({2, 2, 2}, {1, 2, 3}).level));
}

}  // namespace
}  // namespace diefill::process
