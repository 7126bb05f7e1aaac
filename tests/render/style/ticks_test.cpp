#include "render/style/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace diefill::render::test {
namespace {

using Labels = std::vector<std::string>;

TEST(Ticks, StepsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(nice_step({0, 20}, 9), 5);
  EXPECT_DOUBLE_EQ(nice_step({0, 20}, 11), 2);
  EXPECT_DOUBLE_EQ(nice_step({0.3, 0.4}, 6), 0.02);
  EXPECT_DOUBLE_EQ(nice_step({0, 1e6}, 6), 2e5);
  EXPECT_DOUBLE_EQ(nice_step({-3e-7, 3e-7}, 7), 1e-7);
}

TEST(Ticks, NeverMoreThanAskedForAndAllInside) {
  for (const double length : {0.003, 0.07, 1.0, 3.3, 12.0, 47.0, 999.0}) {
    for (const double lower : {-10.0, 0.0, 0.41, 1e4}) {
      for (int most = 2; most < 14; ++most) {
        const Interval range{lower, lower + length};
        const Ticks ticks = nice_ticks(range, most);
        EXPECT_LE(ticks.at.size(), static_cast<std::size_t>(most));
        EXPECT_EQ(ticks.at.size(), ticks.labels.size());
        for (const double at : ticks.at) {
          EXPECT_GE(at, range.lower - 1e-9 * length - 1e-12 * std::abs(lower));
          EXPECT_LE(at, range.upper + 1e-9 * length + 1e-12 * std::abs(lower));
        }
      }
    }
  }
}

TEST(Ticks, LabelsShareDecimalsAndUseTrueMinus) {
  EXPECT_EQ(nice_ticks({0.30, 0.40}, 6).labels, (Labels{"0.30", "0.32", "0.34", "0.36", "0.38", "0.40"}));
  EXPECT_EQ(nice_ticks({-10, 10}, 5).labels, (Labels{"−10", "−5", "0", "5", "10"}));
  EXPECT_EQ(nice_ticks({-0.1, 0.1}, 3).labels, (Labels{"−0.1", "0.0", "0.1"}));
  EXPECT_EQ(tick_label(-1e-17, 0.1), "0.0");
  EXPECT_EQ(tick_label(0.3500005, 5e-7), "0.3500005");
  EXPECT_EQ(tick_label(2e6, 5e5), "2.0·10⁶");
  EXPECT_EQ(tick_label(-3e-7, 1e-7), "−3·10⁻⁷");
  EXPECT_EQ(nice_ticks({0, 4e-7}, 5).labels.front(), "0");
}

TEST(Ticks, AnglesFollowTheCircle) {
  EXPECT_EQ(angle_ticks({0, 360}, 9).labels,
            (Labels{"0", "45", "90", "135", "180", "225", "270", "315", "360"}));
  EXPECT_EQ(angle_ticks({0, 360}, 13).at[1], 30);
  EXPECT_EQ(angle_ticks({0, 360}, 5).at[1], 90);
  EXPECT_EQ(angle_ticks({0, 10}, 6).at[1], 2);
  EXPECT_DOUBLE_EQ(widen_to_angles({5, 355}, 9).lower, 0);
  EXPECT_DOUBLE_EQ(widen_to_angles({5, 355}, 9).upper, 360);
  EXPECT_DOUBLE_EQ(widen_to_angles({1.1, 9}, 6).upper, 10);
}

TEST(Ticks, DecadesAreLabelledAndBetweenOnlyWhereFew) {
  const Ticks wide = decade_ticks({1e-3, 1e6});
  Labels labelled;
  for (const auto& label : wide.labels)
    if (!label.empty()) labelled.push_back(label);
  EXPECT_EQ(labelled, (Labels{"10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹", "10²", "10³", "10⁴", "10⁵", "10⁶"}));
  EXPECT_EQ(wide.at.size(), 9U * 9U + 1U);
  EXPECT_EQ(decade_ticks({1e3, 1e4}).labels.back(), "10000");
  const Ticks narrow = decade_ticks({1, 10});
  EXPECT_EQ(narrow.labels, (Labels{"1", "2", "", "", "5", "", "", "", "", "10"}));
  EXPECT_EQ(decade_ticks({1e-6, 1e-2}).labels.front(), "10⁻⁶");
}

TEST(Ticks, WideningReachesTheNextRoundNumbers) {
  const Interval wide = widen_to_nice({0.313, 0.389}, 6);
  EXPECT_DOUBLE_EQ(wide.lower, 0.30);
  EXPECT_DOUBLE_EQ(wide.upper, 0.40);
  const Interval same = widen_to_nice({0.2, 0.4}, 6);
  EXPECT_DOUBLE_EQ(same.lower, 0.2);
  EXPECT_DOUBLE_EQ(same.upper, 0.4);
}

TEST(RobustRange, LeavesOutliersOutside) {
  std::vector<double> values;
  for (int k = 0; k <= 1000; ++k) values.push_back(0.32 + 0.06 * k / 1000);
  values.push_back(5);
  values.push_back(-5);
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  const Interval range = robust_range(values);
  EXPECT_DOUBLE_EQ(range.lower, 0.32);
  EXPECT_DOUBLE_EQ(range.upper, 0.38);
}

TEST(RobustRange, ConstantFieldGetsAScaleAroundItsValue) {
  const std::vector<double> values(50, 0.35);
  const Interval range = robust_range(values);
  EXPECT_LT(range.lower, 0.35);
  EXPECT_GT(range.upper, 0.35);
  EXPECT_GE(range.length(), 0.02 * 0.35);
  EXPECT_LT(range.length(), 0.05 * 0.35);
  const std::vector<double> zeros(50, 0.0);
  EXPECT_GT(robust_range(zeros).length(), 0);
}

TEST(RobustRange, NoiseIsNotBlownUp) {
  std::vector<double> values;
  for (int k = 0; k < 100; ++k) values.push_back(0.35 + 1e-9 * k);
  EXPECT_GE(robust_range(values).length(), 0.02 * 0.35);
}

TEST(RobustRange, NothingFiniteGivesZeroToOne) {
  const std::vector<double> values(4, std::numeric_limits<double>::quiet_NaN());
  EXPECT_DOUBLE_EQ(robust_range(values).lower, 0);
  EXPECT_DOUBLE_EQ(robust_range(values).upper, 1);
}

}  // namespace
}  // namespace diefill::render::test
