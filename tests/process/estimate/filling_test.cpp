// The law by which inflow slows in a cavity that fills.
#include "process/estimate/discharge/filling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process::estimate {
namespace {

TEST(Filling, IsFreeWhileThereIsRoomAboveThePowder) {
  const FillSpace deep{20e-3, 2e-3};
  const double free = deep.depth - kSlowsBelow * deep.width;
  EXPECT_DOUBLE_EQ(filled_height(deep, 0), 0);
  EXPECT_DOUBLE_EQ(filled_height(deep, 0.999 * free), 0.999 * free);
  EXPECT_LT(filled_height(deep, 1.01 * free), 1.01 * free);
}

TEST(Filling, FollowsItsRateAndNeverExceedsTheDepth) {
  for (const FillSpace& space : {FillSpace{20e-3, 2e-3}, FillSpace{20e-3, 8e-3}, FillSpace{5e-3, 30e-3}}) {
    const double reach = std::min(space.depth, kSlowsBelow * space.width);
    const int steps = 40000;
    double height = 0;
    for (int k = 0; k < steps; ++k)
      height += 3 * space.depth / steps * std::min(1.0, (space.depth - height) / reach);
    EXPECT_NEAR(filled_height(space, 3 * space.depth), height, 1e-4 * space.depth);
    EXPECT_LT(filled_height(space, 20 * space.depth), space.depth * (1 + 1e-12));
  }
}

TEST(Filling, OfTwoCrossingsIsThatOfBothTogether) {
  const FillSpace space{10e-3, 4e-3};
  const double once = filled_height(space, 6e-3);
  EXPECT_NEAR(filled_height(space, offered_for(space, once) + 5e-3), filled_height(space, 11e-3), 1e-12);
}

TEST(Filling, OffersAreFoundFromHeights) {
  for (const FillSpace& space : {FillSpace{20e-3, 2e-3}, FillSpace{5e-3, 30e-3}})
    for (const double share : {0.1, 0.5, 0.9, 0.99})
      EXPECT_NEAR(filled_height(space, offered_for(space, share * space.depth)), share * space.depth, 1e-12);
  EXPECT_TRUE(std::isinf(offered_for({1e-3, 1e-3}, 1e-3)));
}

}  // namespace
}  // namespace diefill::process::estimate
