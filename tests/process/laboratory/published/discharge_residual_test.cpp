// Distances from the measured curve of discharge.
#include "process/laboratory/published/bierwisch/discharge_residual.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/laboratory/published/bierwisch/slit_scene.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kSlit = 6e-3;  // m

TEST(DischargeResidual, IsNoneOnTheCurve) {
  std::vector<PassagePoint> points;
  for (const double speed : {0.18, 0.4, 0.8}) points.push_back({speed, measured_area(kSlit, speed)});
  EXPECT_LT(discharge_residual(points, kSlit), 1e-7);
  EXPECT_LT(largest_deviation(points, kSlit), 1e-12);
}

TEST(DischargeResidual, AreasAreOverTheLargestOneOfTheFittedRange) {
  // 10 mm^2 above the fast end of the curve, where it is nearly level, over 202.6 mm^2.
  const PassagePoint fast = {0.8, measured_area(kSlit, 0.8) + 10e-6};
  EXPECT_NEAR(discharge_residual({fast}, kSlit), std::pow(10 / 202.6, 2), 0.1 * std::pow(10 / 202.6, 2));
  // The mean over points, whatever their slowest speed.
  const PassagePoint on = {0.4, measured_area(kSlit, 0.4)};
  EXPECT_NEAR(discharge_residual({fast, on}, kSlit), 0.5 * discharge_residual({fast}, kSlit), 1e-7);
}

TEST(DischargeResidual, APointMayDeviateByATenthOrTwoSquareMillimetres) {
  EXPECT_NEAR(largest_deviation({{0.18, 1.2 * measured_area(kSlit, 0.18)}}, kSlit), 2, 1e-9);
  EXPECT_NEAR(largest_deviation({{0.8, measured_area(kSlit, 0.8) - 3e-6}}, kSlit), 1.5, 1e-9);
}

}  // namespace
}  // namespace diefill::process::laboratory
