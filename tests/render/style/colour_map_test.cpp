#include "render/style/colour_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::render::test {
namespace {

double distance(const Lab& one, const Lab& other) {
  return std::hypot(one.lightness - other.lightness, one.a - other.a, one.b - other.b);
}

TEST(ColourMap, CielabAgreesWithPublishedValues) {
  EXPECT_NEAR(to_lab({255, 255, 255}).lightness, 100, 0.01);
  EXPECT_NEAR(to_lab({0, 0, 0}).lightness, 0, 1e-9);
  const Lab red = to_lab({255, 0, 0});
  EXPECT_NEAR(red.lightness, 53.24, 0.02);
  EXPECT_NEAR(red.a, 80.09, 0.05);
  EXPECT_NEAR(red.b, 67.20, 0.05);
  const Lab blue = to_lab({0, 0, 255});
  EXPECT_NEAR(blue.lightness, 32.30, 0.02);
  EXPECT_NEAR(blue.b, -107.86, 0.05);
}

TEST(ColourMap, LightnessRisesAllTheWay) {
  double before = to_lab(map_colour(0)).lightness;
  for (int k = 1; k < 128; ++k) {
    const double now = to_lab(map_colour(k / 127.0)).lightness;
    EXPECT_GT(now, before) << "at " << k;
    before = now;
  }
  EXPECT_LT(to_lab(map_colour(0)).lightness, 20);
  EXPECT_GT(to_lab(map_colour(1)).lightness, 88);
}

TEST(ColourMap, EqualStepsLookEqual) {
  constexpr int kSteps = 20;
  double least = std::numeric_limits<double>::max(), most = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double step =
        to_lab(map_colour((k + 1.0) / kSteps)).lightness - to_lab(map_colour(1.0 * k / kSteps)).lightness;
    least = std::min(least, step);
    most = std::max(most, step);
  }
  EXPECT_LT(most / least, 1.6);
}

TEST(ColourMap, HasViridisAtItsEndsAndMiddle) {
  EXPECT_EQ(map_colour(0), (Rgb{68, 1, 84}));
  EXPECT_EQ(map_colour(1), (Rgb{253, 231, 37}));
  const Rgb middle = map_colour(0.5);
  EXPECT_NEAR(middle.red, 33, 2);
  EXPECT_NEAR(middle.green, 144, 2);
  EXPECT_NEAR(middle.blue, 141, 2);
}

TEST(ColourMap, ClampsOutsideAndKeepsGreyForNoValue) {
  EXPECT_EQ(map_colour(-3), map_colour(0));
  EXPECT_EQ(map_colour(7), map_colour(1));
  EXPECT_EQ(map_colour(std::nan("")), kNoValueColour);
  EXPECT_EQ(value_colour(std::nan(""), 0, 1), kNoValueColour);
  EXPECT_EQ(value_colour(3, 2, 4), map_colour(0.5));
  EXPECT_EQ(value_colour(3, 3, 3), map_colour(0.5));
}

TEST(ColourMap, GreyOfNoValueIsNeutralAndUnlikeEveryMapColour) {
  const Lab grey = to_lab(kNoValueColour);
  EXPECT_NEAR(grey.a, 0, 0.01);
  EXPECT_NEAR(grey.b, 0, 0.02);
  for (int k = 0; k <= 100; ++k) EXPECT_GT(distance(grey, to_lab(map_colour(k / 100.0))), 25) << "at " << k;
}

}  // namespace
}  // namespace diefill::render::test
