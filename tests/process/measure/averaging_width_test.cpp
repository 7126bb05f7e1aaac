// Width of the Gaussian of fields: default, limits, and that of a result.
#include "process/measure/fields/averaging_width.h"

#include <gtest/gtest.h>

namespace diefill::process {
namespace {

TEST(AveragingWidth, TheDefaultLiesWithinTheLimits) {
  for (const double grain : {1e-5, 4.7e-4, 4.5e-3})
    for (const double edge : {0.0, 1e-4, 1.6e-2}) {
      EXPECT_GE(default_averaging_width(grain), least_averaging_width(grain));
      EXPECT_LE(default_averaging_width(grain), largest_averaging_width(grain, edge));
    }
  EXPECT_DOUBLE_EQ(least_averaging_width(1e-3), 1e-4);
  EXPECT_DOUBLE_EQ(largest_averaging_width(1e-3, 1.6e-2), 1.6e-2);
}

TEST(AveragingWidth, TheUsualOneOfAResultIsThatOfItsFields) {
  results::FillResult result;
  result.powder.grain_diameter = 2e-3;
  EXPECT_DOUBLE_EQ(usual_averaging_width(result), 1e-3);  // without fields
  result.sections.emplace_back();
  result.sections.front().field.averaging_width = 7e-4;
  EXPECT_DOUBLE_EQ(measured_averaging_width(result), 7e-4);
  EXPECT_DOUBLE_EQ(usual_averaging_width(result), 7e-4);
  result.sections.front().field.averaging_width = 1e-6;
  EXPECT_DOUBLE_EQ(usual_averaging_width(result), 2e-4);
}

}  // namespace
}  // namespace diefill::process
