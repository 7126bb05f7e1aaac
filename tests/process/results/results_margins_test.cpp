// Limits of the method: on which side they count.
#include <gtest/gtest.h>

#include "process/results/margins.h"
#include "process/run/figures/margin_warnings.h"

namespace diefill::results {
namespace {

FillResult run_with(double energy_error) {
  FillResult result;
  result.figures = {{"time_step_fraction", 0.4},
                    {"deepest_overlap_ratio", 0.3},
                    {"overlap_limit_ratio", 0.6},
                    {"energy_balance_error", energy_error},
                    {"energy_error_limit", 0.05}};
  return result;
}

TEST(Margins, EnergyCountsEitherWayAndIsNeverNegative) {
  const auto all = margins(run_with(-0.097));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(all[0].share(), 0.4, 1e-15);
  EXPECT_NEAR(all[2].share(), 1.94, 1e-12);
  EXPECT_TRUE(all[2].either_side);
  EXPECT_TRUE(all[2].exceeded());
  EXPECT_FALSE(margins(run_with(0.049))[2].exceeded());
  EXPECT_TRUE(margins(run_with(0.051))[2].exceeded());
}

TEST(Margins, WhatIsBeyondALimitIsAWarning) {
  const auto lost = exceeded_text(run_with(-0.097));
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_NE(lost[0].find("9.7 % of the energy exchanged was lost"), std::string::npos) << lost[0];
  EXPECT_TRUE(exceeded_text(run_with(-0.04)).empty());
  FillResult deep = run_with(0);
  deep.figures["deepest_overlap_ratio"] = 0.7;
  ASSERT_EQ(exceeded_text(deep).size(), 1U);
  EXPECT_NE(exceeded_text(deep)[0].find("reached 0.7"), std::string::npos);
}

TEST(Margins, EnergyLostBeyondWhatIsComfortableIsAWarningOfTheRun) {
  EXPECT_TRUE(process::margin_warnings(run_with(-0.009)).empty());
  ASSERT_EQ(process::margin_warnings(run_with(-0.02)).size(), 1U);
  EXPECT_NE(process::margin_warnings(run_with(-0.02))[0].find("2.0 % of the energy"), std::string::npos);
  EXPECT_EQ(process::margin_warnings(run_with(-0.2)).size(), 1U);
}

TEST(Margins, AreLeftOutWhereARunHasNone) {
  EXPECT_TRUE(margins({}).empty());
}

}  // namespace
}  // namespace diefill::results
