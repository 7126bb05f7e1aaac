// Distances of points from curves with known geometry.
#include "process/calibration/methods/curve_residual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace diefill::process::calibration {
namespace {

/// Discharged area against shoe speed of ASC100.29 through a slit of 6 mm (Bierwisch 2009, Eq. 4.1 with Table
/// 4.1), m/s and mm^2.
double discharged_area(double speed) {
  constexpr double kBurst = 0.081, kInitial = 0.024, kFlow = 4.3, kBeta = 0.093, kStart = 0.2;
  constexpr double kSlit = 6, kShoe = 32, kGravity = 9.81;
  const double x = std::sqrt(kGravity * kSlit * 1e-3) / speed - kStart;
  return kSlit * kShoe * (kBurst + kFlow * (x + (1 - kInitial / kFlow) / kBeta * (std::exp(-kBeta * x) - 1)));
}

MeasuredCurve discharge_curve(int points) {
  std::vector<double> x, y;
  for (int k = 0; k < points; ++k) {
    x.push_back(0.1 + 0.7 * k / (points - 1));
    y.push_back(discharged_area(x.back()));
  }
  return curve_through(x, y);
}

TEST(CurveResidual, TheReferenceCurveIsThePublishedOne) {
  EXPECT_NEAR(discharged_area(0.1), 202.6, 0.05);
  EXPECT_NEAR(discharged_area(0.18), 69.4, 0.05);
  EXPECT_NEAR(discharged_area(0.8), 16.4, 0.05);
}

TEST(CurveResidual, ThePerpendicularOfALineIsExact) {
  const MeasuredCurve line{{0, 4}, {0, 3}, 1, 1};
  EXPECT_NEAR(distance_from(line, 2, 1.5), 0, 1e-15);
  EXPECT_NEAR(distance_from(line, 2 - 0.6, 1.5 + 0.8), 1, 1e-15);  // (-3, 4) / 5 stands on (4, 3) / 5
  EXPECT_NEAR(distance_from(line, -3, -4), 5, 1e-15);              // beyond the end: from the end point
}

TEST(CurveResidual, BothCoordinatesAreDividedByTheirScales) {
  const MeasuredCurve curve = curve_through({0, 2}, {0, 50});
  EXPECT_EQ(curve.x_scale, 2);
  EXPECT_EQ(curve.y_scale, 50);
  // In scaled coordinates the curve is the diagonal; (1, 0) is sqrt(1/2) away.
  EXPECT_NEAR(distance_from(curve, 2, 0), std::sqrt(0.5), 1e-15);
}

TEST(CurveResidual, PointsMovedAlongTheNormalAreFoundAtTheirDistance) {
  const MeasuredCurve curve = discharge_curve(4001);
  constexpr double kOff = 0.01, kStep = 1e-5;
  std::vector<double> x, y;
  for (const double speed : {0.15, 0.18, 0.25, 0.4, 0.6}) {
    const double slope = (discharged_area(speed + kStep) - discharged_area(speed - kStep)) / (2 * kStep) *
                         curve.x_scale / curve.y_scale;
    const double length = std::hypot(1, slope);
    x.push_back(speed + kOff * curve.x_scale * -slope / length);
    y.push_back(discharged_area(speed) + kOff * curve.y_scale / length);
    EXPECT_NEAR(distance_from(curve, x.back(), y.back()), kOff, 1e-6) << speed;
  }
  EXPECT_NEAR(mean_square_residual(curve, x, y), kOff * kOff, 1e-7);
}

TEST(CurveResidual, APerpendicularIsShorterThanTheVerticalWhereTheCurveIsSteep) {
  const MeasuredCurve curve = discharge_curve(1001);
  const double vertical = 0.1;  // in the scale of areas
  const double found = distance_from(curve, 0.12, discharged_area(0.12) + vertical * curve.y_scale);
  EXPECT_LT(found, 0.3 * vertical);
  EXPECT_GT(found, 0);
}

TEST(CurveResidual, TheMapHasItsLeastValueAtThePlantedParameters) {
  const MeasuredCurve curve = discharge_curve(8);  // 0.1, 0.2, ... 0.8 m/s
  const std::vector<double> speeds = {0.1, 0.2, 0.4, 0.8};
  const auto residual = [&](double factor, double offset) {
    std::vector<double> areas;
    for (const double speed : speeds) areas.push_back(factor * discharged_area(speed) + offset);
    return mean_square_residual(curve, speeds, areas);
  };
  const MapAxis first{"factor", "1", {0.8, 0.9, 1, 1.1}}, second{"offset", "mm^2", {-10, 0, 10}};
  const auto map = residual_map("residual", first, second, residual);
  ASSERT_EQ(map.value.size(), 12U);
  std::size_t least = 0;
  for (std::size_t k = 0; k < map.value.size(); ++k)
    if (map.value[k] < map.value[least]) least = k;
  EXPECT_EQ(least, 1U * 4 + 2);
  EXPECT_LT(map.value[least], 1e-12);
  EXPECT_NEAR(map.value[0], residual(0.8, -10), 1e-15);
}

TEST(CurveResidual, CurvesThatAreNoneAreRefused) {
  EXPECT_THROW(curve_through({1}, {1}), std::invalid_argument);
  EXPECT_THROW(curve_through({1, 1}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(curve_through({2, 1}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(curve_through({1, 2}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(mean_square_residual(curve_through({1, 2}, {1, 2}), {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::calibration
