#include "render/fields/arrow_map.h"

#include <gtest/gtest.h>

#include "render/fields/arrow_painter.h"

namespace diefill::render::test {
namespace {

results::ArrowField arrows_of_length(double length) {
  results::ArrowField arrows;
  arrows.unit = "mm/s";
  for (int k = 0; k < 50; ++k) {
    arrows.field.value.push_back(length);
    arrows.arrows.push_back({static_cast<double>(k), 1, length, 0});
  }
  return arrows;
}

// The same colour and the same arrow mean the same speed in all pictures.
TEST(ArrowScales, OfSeveralRunsAreOne) {
  const ArrowScale slow = common_scale({arrows_of_length(1)}),
                   both = common_scale({arrows_of_length(1), arrows_of_length(10)});
  EXPECT_LT(slow.upper, 1.1);
  EXPECT_GE(both.upper, 10);
  EXPECT_EQ(slow.arrow_length, 1);
  EXPECT_EQ(both.arrow_length, 10);
}

TEST(ArrowScales, OfPowderAtRestHaveALength) {
  const ArrowScale rest = common_scale({arrows_of_length(0)});
  EXPECT_GT(rest.upper, 0);
  EXPECT_GT(rest.arrow_length, 0);
}

}  // namespace
}  // namespace diefill::render::test
