// How filling varies round a ring and over its height, against numbers worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/measure/measure.h"

namespace diefill::process {
namespace {

const double kNone = std::nan("");

results::CavityState ring() {
  results::CavityState cavity;
  cavity.is_ring = true;
  cavity.inner_radius = 8e-3;
  cavity.outer_radius = 10e-3;
  cavity.lower_corner = {-10e-3, -10e-3, -15e-3};
  cavity.upper_corner = {10e-3, 10e-3, 0};
  cavity.volume = 1.6e-6;
  cavity.azimuth_zero = {1, 0, 0};
  return cavity;
}

/// One grain of 1e-9 m^3 at each azimuth (deg), all in the cavity.
results::PowderState grains_at(const std::vector<double>& azimuths) {
  results::PowderState powder;
  powder.grain_solid_volume = 1e-9;
  for (const double azimuth : azimuths) {
    const double angle = azimuth * std::numbers::pi / 180;
    powder.position.emplace_back(9e-3 * std::cos(angle), 9e-3 * std::sin(angle), -5e-3);
  }
  return powder;
}

TEST(SectorFilling, IsSolidVolumeOverTheSectorsVolume) {
  const auto powder = grains_at({10, 80, 100, 300});
  results::GrainSolidFraction fraction;
  fraction.in_cavity = {1, 1, 1, 1};
  const auto filling = sector_filling(powder, fraction, ring(), 4);
  EXPECT_EQ(filling.x, (std::vector<double>{45, 135, 225, 315}));
  const double one = 1e-9 / 0.4e-6;
  const std::vector<double> grains = {2, 1, 0, 1};
  for (std::size_t sector = 0; sector < 4; ++sector)
    EXPECT_NEAR(filling.y[sector], one * grains[sector], 1e-15);
}

TEST(SectorFilling, LeavesGrainsOutsideTheCavityOut) {
  const auto powder = grains_at({10, 100});
  results::GrainSolidFraction fraction;
  fraction.in_cavity = {0, 1};
  const auto filling = sector_filling(powder, fraction, ring(), 2);
  EXPECT_EQ(filling.y[1], 0);
  EXPECT_NEAR(filling.y[0], 1e-9 / 0.8e-6, 1e-15);
}

TEST(SectorFilling, WantsARing) {
  EXPECT_THROW(sector_filling({}, {}, {}, 12), std::invalid_argument);
  EXPECT_THROW(sector_filling({}, {}, ring(), 0), std::invalid_argument);
}

TEST(HeightProfile, AveragesRowsThatAreAtLeastHalfKnownAndCountsTheSeamOnce) {
  const results::Field2D map{"solid fraction",
                             "azimuth",
                             "deg",
                             "height",
                             "mm",
                             {0, 120, 240, 360},
                             {0, 1, 2},
                             {0.3, 0.4, 0.5, 0.3, 0.3, kNone, 0.5, 0.3, kNone, kNone, 0.5, kNone},
                             5e-4};
  const auto profile = height_profile(map);
  EXPECT_EQ(profile.x, map.second);
  EXPECT_NEAR(profile.y[0], 0.4, 1e-15);
  EXPECT_NEAR(profile.y[1], 0.4, 1e-15);
  EXPECT_TRUE(std::isnan(profile.y[2]));
}

TEST(RelativeRange, IsRangeOverMeanOfWhatIsKnown) {
  EXPECT_NEAR(relative_range({"", "", "", "", {0, 1, 2, 3}, {0.2, kNone, 0.3, 0.4}}), 0.2 / 0.3, 1e-15);
  EXPECT_EQ(relative_range({"", "", "", "", {0, 1}, {0.2, 0.2}}), 0);
  EXPECT_TRUE(std::isnan(relative_range({"", "", "", "", {0}, {kNone}})));
}

TEST(BulkSolidFraction, CountsOnlyDeepClosedCells) {
  results::PowderState powder;
  powder.grain_diameter = 1e-3;
  powder.grain_solid_volume = 4e-10;
  results::GrainSolidFraction fraction;
  for (int layer = 0; layer < 4; ++layer) {
    powder.position.emplace_back(0, 0, 1e-3 * layer);
    fraction.cell_volume.push_back(1e-9 * (layer + 1));
    fraction.solid_fraction.push_back(0.4 / (layer + 1));
    fraction.open.push_back(0);
    fraction.in_cavity.push_back(layer == 0);
  }
  EXPECT_NEAR(bulk_solid_fraction(powder, fraction), 8e-10 / 3e-9, 1e-12);
}

}  // namespace
}  // namespace diefill::process
