// Offset and collapse of discharges that are known.
#include "process/laboratory/published/bierwisch/slit_collapse.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process::laboratory {
namespace {

/// Rates (D - `offset` d)^`power` of two sizes through three slits, that of the coarse ones times `coarse`.
SlitPoints points(double offset, double power, double coarse = 1) {
  SlitPoints made;
  for (const double diameter : {1.88e-3, 2.82e-3})
    for (const double width : {9e-3, 11.5e-3, 14e-3}) {
      made.width.push_back(width);
      made.diameter.push_back(diameter);
      made.rate.push_back((diameter > 2e-3 ? coarse : 1) * std::pow(width - offset * diameter, power));
    }
  return made;
}

TEST(SlitCollapse, OffsetOfTheLawItselfComesBack) {
  EXPECT_NEAR(fitted_offset(points(1.4, 1.5)).value, 1.4, 1e-9);
  EXPECT_NEAR(fitted_offset(points(1.2, 1.5)).value, 1.2, 1e-9);
  EXPECT_LT(fitted_offset(points(1.4, 1.5)).error, 1e-6);
}

TEST(SlitCollapse, AnyPowerIsOneCurve) {
  for (const double power : {1.0, 1.5, 1.8}) EXPECT_NEAR(spread_about_one_curve(points(1.4, power)), 0, 1e-9);
  EXPECT_LT(lack_of_slit_collapse(points(1.4, 1.5)), 1e-6);
}

TEST(SlitCollapse, AsksForOffsetAndSpread) {
  EXPECT_NEAR(lack_of_slit_collapse(points(1.65, 1.5)), 0.25 / 0.3, 1e-6);
  EXPECT_GT(lack_of_slit_collapse(points(1.9, 1.5)), 1);
  // The right offset over another curve: sizes differ by a fifth at the same D - 1.4 d.
  const SlitPoints apart = points(1.4, 1.5, 1.2);
  EXPECT_GT(spread_about_one_curve(apart), 0.05);
  EXPECT_GT(lack_of_slit_collapse(apart), 1);
}

TEST(SlitCollapse, NothingWithoutRates) {
  SlitPoints none = points(1.4, 1.5);
  none.rate[2] = std::nan("");
  EXPECT_TRUE(std::isnan(lack_of_slit_collapse(none)));
  SlitPoints narrow = points(1.4, 1.5);
  narrow.width[0] = 2e-3;
  EXPECT_TRUE(std::isnan(spread_about_one_curve(narrow)));
  EXPECT_TRUE(std::isnan(fitted_offset({}).value));
}

}  // namespace
}  // namespace diefill::process::laboratory
