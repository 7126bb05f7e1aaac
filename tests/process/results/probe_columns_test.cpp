// Columns of probes by name, in users' units, and at other times.
#include "process/results/probe_columns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::results {
namespace {

FillResult recorded() {
  FillResult result;
  result.probes = {{"piston",
                    {"time", "force z", "shift z", "shift x"},
                    {"s", "N", "m", "m"},
                    {0, 1, 0, 0, 0.1, 3, -0.002, 0, 0.2, 7, -0.004, 0}},
                   {"filled mass", {"time", "filled mass"}, {"s", "kg"}, {0.05, 0.001, 0.15, 0.003}}};
  return result;
}

TEST(ProbeColumns, AreFoundByProbeAndColumn) {
  const FillResult result = recorded();
  const auto force = find_column(result, "piston/force z");
  ASSERT_TRUE(force);
  EXPECT_EQ(force->unit, "N");
  EXPECT_EQ(force->time, (std::vector<double>{0, 0.1, 0.2}));
  EXPECT_EQ(force->values, (std::vector<double>{1, 3, 7}));
  EXPECT_EQ(find_column(result, "filled mass")->name, "filled mass/filled mass");
  EXPECT_FALSE(find_column(result, "piston/time"));
  EXPECT_FALSE(find_column(result, "punch/force z"));
  EXPECT_EQ(column_names(result).size(), 4U);
}

TEST(ProbeColumns, OfOneUnitShareAChart) {
  const FillResult result = recorded();
  EXPECT_EQ(columns_of_one_unit(result.probes[0]), (std::vector<std::string>{"piston/force z"}));
}

TEST(ProbeColumns, AreShownInGramsAndMillimetres) {
  const FillResult result = recorded();
  const ProbeColumn shift = in_shown_unit(*find_column(result, "piston/shift z"));
  EXPECT_EQ(shift.unit, "mm");
  EXPECT_NEAR(shift.values.back(), -4, 1e-12);
  EXPECT_EQ(in_shown_unit(*find_column(result, "filled mass")).unit, "g");
  EXPECT_EQ(in_shown_unit(*find_column(result, "piston/force z")).unit, "N");
}

TEST(ProbeColumns, AtOtherTimesAreLinearBetweenTheirRowsAndNothingBeyond) {
  const ProbeColumn force = *find_column(recorded(), "piston/force z");
  const auto values = values_at(force, {-0.1, 0, 0.05, 0.15, 0.2, 0.3});
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], 1);
  EXPECT_NEAR(values[2], 2, 1e-12);
  EXPECT_NEAR(values[3], 5, 1e-12);
  EXPECT_EQ(values[4], 7);
  EXPECT_TRUE(std::isnan(values[5]));
}

}  // namespace
}  // namespace diefill::results
