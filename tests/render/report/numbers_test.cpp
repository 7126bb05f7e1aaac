// Numbers of a report: a column of a table has one number of decimals.
#include "render/report/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace diefill::render::report {
namespace {

using Texts = std::vector<std::string>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ReportNumbers, AColumnHasOneNumberOfDecimals) {
  EXPECT_EQ(in_one_format({0.4, 0.412, 0.0301}, 3), (Texts{"0.400", "0.412", "0.030"}));
  EXPECT_EQ(in_one_format({12.34, 0.412, -3}, 3), (Texts{"12.3", "0.4", "-3.0"}));
  EXPECT_EQ(in_one_format({1234.5, 7.25}, 3), (Texts{"1234", "7"}));
  EXPECT_EQ(in_one_format({0.5, kNaN, 0}, 2), (Texts{"0.50", "–", "0.00"}));
}

TEST(ReportNumbers, WholeNumbersHaveNoDecimals) {
  EXPECT_EQ(in_one_format({87041, 12, 0}, 3), (Texts{"87041", "12", "0"}));
}

TEST(ReportNumbers, NoValueOfAColumnIsShownAsZeroButZero) {
  EXPECT_EQ(in_one_format({0.4, 0.00012}, 2), (Texts{"0.4", "0.00012"}));
}

TEST(ReportNumbers, MeansAloneHaveOneNumberOfDecimalsBesideThoseWithScatter) {
  EXPECT_EQ(as_texts({{0.4, kNaN, 1}, {0.3124, 0.004, 3}, {0.412, kNaN, 1}, {kNaN, kNaN, 0}}, 3),
            (Texts{"0.400", "0.312 ± 0.004", "0.412", "–"}));
}

}  // namespace
}  // namespace diefill::render::report
