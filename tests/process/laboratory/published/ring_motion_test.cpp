// Powder in a ring between two instants: what changes near the surface, and how deep it moves.
#include "process/laboratory/published/bierwisch/ring_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace diefill::process::laboratory {
namespace {

constexpr RingSpace kRing = {8e-3, 12e-3, 20e-3};

/// Grains of 1 mm: `layers` layers of it from the bottom, a grain in each of 60 places about the axis.
results::PowderState filled(int layers) {
  results::PowderState powder;
  powder.grain_diameter = 1e-3;
  powder.grain_solid_volume = 0.35 * std::numbers::pi * (144 - 64) * 1e-6 / 60 * 1e-3;
  for (int layer = 0; layer < layers; ++layer)
    for (int k = 0; k < 60; ++k) {
      const double angle = (k + 0.5) / 60 * 2 * std::numbers::pi;
      powder.id.push_back(powder.id.size());
      powder.position.emplace_back(0.01 * std::cos(angle), 0.01 * std::sin(angle),
                                   -kRing.depth + (layer + 0.5) * 1e-3);
    }
  return powder;
}

TEST(RingMotion, LayersOnTopAreAChangeNearTheSurface) {
  EXPECT_NEAR(change_near_surface(filled(10), filled(12), kRing), 1, 1e-12);
  // As many grains that condense at the bottom are a change below it.
  auto denser = filled(12);
  for (std::size_t k = 0; k < 120; ++k) denser.position.push_back(denser.position[k]);
  EXPECT_NEAR(change_near_surface(filled(10), denser, kRing), 0.5, 1e-12);
}

TEST(RingMotion, DepthIsThatOfTheLowestMovedLayer) {
  const auto before = filled(20);
  auto after = before;
  // The upper five layers turn by 2 mm; one grain of the lowest alone is no motion of its layer.
  for (std::size_t k = 15 * 60; k < after.position.size(); ++k) after.position[k].x() += 2e-3;
  after.position[0].x() += 2e-3;
  EXPECT_NEAR(depth_of_motion(before, after, kRing), 5e-3, 1e-9);
  const auto shares = moved_shares(before, after, kRing);
  ASSERT_EQ(shares.size(), 20U);
  EXPECT_EQ(shares[4], 1);
  EXPECT_EQ(shares[5], 0);
  EXPECT_NEAR(shares[19], 1.0 / 60, 1e-12);
  EXPECT_NEAR(mean_motion(before, after), 2.0 * (5 * 60 + 1) / (20 * 60), 1e-9);
  EXPECT_EQ(depth_of_motion(before, before, kRing), 0);
}

TEST(RingMotion, OnlyPowderBelowTheEdgeIsInTheRing) {
  auto powder = filled(3);
  const double all = filled_volume(powder);
  EXPECT_NEAR(filled_volume(powder, true), 0.5 * all, 1e-15);
  powder.position.emplace_back(0.01, 0, 1e-4);
  EXPECT_EQ(filled_volume(powder), all);
}

}  // namespace
}  // namespace diefill::process::laboratory
