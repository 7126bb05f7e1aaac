// Numbers carry the digits that their scatter leaves.
#include <gtest/gtest.h>

#include <cmath>

#include "process/results/formatted.h"
#include "process/results/full_die.h"
#include "process/results/rounding.h"

namespace diefill::results {
namespace {

TEST(Rounding, DigitsFollowTheScatter) {
  EXPECT_EQ(with_scatter(37.92, 53.55), "40 ± 50");
  EXPECT_EQ(with_scatter(0.31184, 0.0523), "0.31 ± 0.05");
  EXPECT_EQ(with_scatter(0.31184, 0.0123), "0.312 ± 0.012");
  EXPECT_EQ(with_scatter(3.4567, 0.0296), "3.46 ± 0.03");
  EXPECT_EQ(with_scatter(1234.5, 21), "1234 ± 21");
  EXPECT_EQ(with_scatter(-0.0004, 0.02), "0.000 ± 0.020");
}

TEST(Rounding, ValuesWithoutScatterKeepAFewDigits) {
  EXPECT_EQ(with_scatter(0.31184, std::nan("")), "0.312");
  EXPECT_EQ(with_scatter(87041, std::nan("")), "87041");
  EXPECT_EQ(with_scatter(3.4567, 0), "3.46 ± 0");
  EXPECT_EQ(with_scatter(3.4567891, 1e-9), "3.4568 ± 1e-09");
  EXPECT_EQ(with_scatter(0.31, 8e-17), "0.31 ± 0") << "rounding of a sum";
  EXPECT_EQ(with_scatter(std::nan(""), 1), "");
}

TEST(Formatted, ShowsZeroWithoutASign) {
  EXPECT_EQ(formatted("(%.2f, %.2f, %.2f) mm", 8.0, -0.0014, -6.97), "(8.00, 0.00, -6.97) mm");
  EXPECT_EQ(formatted("%.1f", -0.04), "0.0");
  EXPECT_EQ(formatted("at %.2f.", -0.0), "at 0.00.");
  EXPECT_EQ(formatted("%.3e", -0.0), "-0.000e+00");
  EXPECT_EQ(formatted("%.3f and %.2f", -0.002, -0.01), "-0.002 and -0.01");
  EXPECT_EQ(formatted("%.17g", -0.0), "-0") << "written to be read again";
}

TEST(Rounding, SharesAreInWholePercent) {
  EXPECT_EQ(whole_percent(0.426), "43 %");
  EXPECT_EQ(whole_percent(1.2), "120 %");
  EXPECT_EQ(whole_percent(-0.001), "0 %");
}

TEST(Rounding, MassesAreInGramsOrMilligrams) {
  EXPECT_EQ(mass_text(3.1234e-3), "3.12 g");
  EXPECT_EQ(mass_text(3.1234e-3, 2), "3.1 g");
  EXPECT_EQ(mass_text(4.56e-5), "45.6 mg");
  EXPECT_EQ(mass_text(1.234), "1234 g");
  EXPECT_EQ(mass_text(0), "0 g");
}

TEST(FullDie, CountsFromWhatReadsAs98PerCent) {
  EXPECT_TRUE(is_full(0.98));
  EXPECT_TRUE(is_full(0.976));
  EXPECT_FALSE(is_full(0.974));
  EXPECT_TRUE(is_full(1.1));
  EXPECT_FALSE(is_full(std::nan("")));
}

TEST(Rounding, ScatterOfRoundingAloneLeavesFiveDigits) {
  EXPECT_EQ(at_decimals(0.47, decimals_of_scatter(1e-15, 0.47)), "0.47000");
  EXPECT_EQ(at_decimals(1e-15, decimals_of_scatter(1e-15, 0.47)), "0.00000");
  EXPECT_EQ(decimals_of_scatter(0.05, 0.47), decimals_of_scatter(0.05));
}

}  // namespace
}  // namespace diefill::results
