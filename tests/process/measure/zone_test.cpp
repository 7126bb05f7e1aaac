// Zones of a part: which grains they hold, and the figures of known powder.
#include <gtest/gtest.h>

#include <cmath>

#include "process/measure/figures/zone_history.h"
#include "process/results/no_value.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

Zone heights(const std::string& name, double lower, double upper) {
  Zone zone;
  zone.name = name;
  zone.lower[2] = lower;
  zone.upper[2] = upper;
  return zone;
}

/// A block of grains with solid fraction 0.3 below z = 0 and 0.4 above.
results::FillResult two_halves() {
  results::FillResult result;
  result.powder = powder_of(block(8, kDiameter));
  result.solid_fraction =
      fraction_of(result.powder, [](const Eigen::Vector3d& at) { return at.z() < 0 ? 0.3 : 0.4; });
  result.cavity.volume = 1e-6;
  return result;
}

TEST(Zones, HoldWhatLiesWithinAllTheirLimits) {
  Zone zone = heights("ring", -1, 1);
  zone.axis = {2, 0};
  zone.inner_radius = 1;
  zone.outer_radius = 3;
  EXPECT_TRUE(zone.contains({4, 0, 0}));
  EXPECT_FALSE(zone.contains({2.5, 0, 0}));  // within the inner cylinder
  EXPECT_FALSE(zone.contains({5.5, 0, 0}));
  EXPECT_FALSE(zone.contains({4, 0, 1.5}));
  EXPECT_TRUE(Zone().contains({1e3, -1e3, 1e3}));
}

TEST(Zones, FiguresAreThoseOfTheirGrains) {
  results::FillResult result = two_halves();
  add_zone_figures(result, {heights("lower half", -1, 0), heights("upper half", 0, 1)});
  const double all = result.powder.grain_mass * static_cast<double>(result.powder.position.size());
  EXPECT_NEAR(result.figures.at("solid_fraction_in_lower_half"), 0.3, 1e-9);
  EXPECT_NEAR(result.figures.at("solid_fraction_in_upper_half"), 0.4, 1e-9);
  EXPECT_NEAR(
      result.figures.at("filled_mass_in_lower_half_kg") + result.figures.at("filled_mass_in_upper_half_kg"),
      all, 1e-9 * all);
  EXPECT_NEAR(result.figures.at("mass_share_in_lower_half"), 0.5, 1e-9);
}

TEST(Zones, CountTheCavityAloneAndNoOpenCells) {
  results::FillResult result = two_halves();
  for (std::size_t k = 0; k < result.powder.position.size(); ++k) {
    if (result.powder.position[k].x() > 0) result.solid_fraction.in_cavity[k] = 0;
    // A cell at the surface has no meaningful volume.
    if (result.powder.position[k].y() > 0) {
      result.solid_fraction.open[k] = 1;
      result.solid_fraction.cell_volume[k] = 1;
    }
  }
  add_zone_figures(result, {heights("lower", -1, 0)});
  EXPECT_NEAR(result.figures.at("solid_fraction_in_lower"), 0.3, 1e-9);
  EXPECT_NEAR(result.figures.at("mass_share_in_lower"), 0.5, 1e-9);
  const double all = result.powder.grain_mass * static_cast<double>(result.powder.position.size());
  EXPECT_NEAR(result.figures.at("filled_mass_in_lower_kg"), 0.25 * all, 1e-9 * all);
}

TEST(Zones, CountThePowderInAllCavities) {
  results::FillResult result = two_halves();
  const double largest = 1;  // m, beyond all grains
  results::CavityState second;
  second.lower_corner = {0, -largest, -largest};
  second.upper_corner = {largest, largest, largest};
  for (std::size_t k = 0; k < result.powder.position.size(); ++k)
    if (result.powder.position[k].x() >= 0) result.solid_fraction.in_cavity[k] = 0;
  const double all = result.powder.grain_mass * static_cast<double>(result.powder.position.size());
  add_zone_figures(result, {heights("lower", -1, 0)});
  EXPECT_NEAR(result.figures.at("filled_mass_in_lower_kg"), 0.25 * all, 1e-9 * all);
  result.other_cavities = {second};
  add_zone_figures(result, {heights("lower", -1, 0)});
  EXPECT_NEAR(result.figures.at("filled_mass_in_lower_kg"), 0.5 * all, 1e-9 * all);
  EXPECT_NEAR(result.figures.at("mass_share_in_lower"), 0.5, 1e-9);
}

TEST(Zones, HaveNoSolidFractionOnFewGrains) {
  results::FillResult result = two_halves();
  add_zone_figures(result, {heights("far away", 5, 6)});
  EXPECT_TRUE(std::isnan(result.figures.at("solid_fraction_in_far_away")));
  EXPECT_EQ(result.figures.at("filled_mass_in_far_away_kg"), 0);
  EXPECT_NE(results::reason_for(result, "solid_fraction_in_far_away")
                .find("no grain lies below the surface in zone \"far away\""),
            std::string::npos);
}

/// The block as it was, moved up by `rise` (m).
results::Instant earlier_block(const results::FillResult& result, double time, double rise) {
  results::Instant instant;
  instant.time = time;
  instant.id = result.powder.id;
  instant.position = result.powder.position;
  for (auto& place : instant.position) place.z() += rise;
  instant.orientation = result.powder.orientation;
  instant.velocity = result.powder.velocity;
  return instant;
}

TEST(ZoneHistories, HaveARowForEveryInstantAndTheEnd) {
  results::FillResult result = two_halves();
  result.powder.time = 0.3;
  result.instants = {earlier_block(result, 0.1, 0.5), earlier_block(result, 0.2, 0)};
  result.cavity.volume = 0;  // all powder counts
  const auto histories = zone_histories(result, {heights("low", -1, 0), heights("high", 0, 1)});
  ASSERT_EQ(histories.size(), 2U);
  EXPECT_EQ(histories[0].name, "zone low");
  const auto value = [&](std::size_t zone, std::size_t row, std::size_t column) {
    return histories[zone].values.at(4 * row + column);
  };
  ASSERT_EQ(histories[0].values.size(), 12U);
  const double all = result.powder.grain_mass * static_cast<double>(result.powder.position.size());
  EXPECT_EQ(value(0, 0, 0), 0.1);
  EXPECT_EQ(value(0, 0, 1), 0);  // all above
  EXPECT_TRUE(std::isnan(value(0, 0, 3)));
  EXPECT_NEAR(value(1, 0, 1), all, 1e-9 * all);
  EXPECT_NEAR(value(0, 1, 2), 0.5, 1e-9);
  EXPECT_EQ(value(0, 2, 0), 0.3);
  EXPECT_NEAR(value(0, 2, 3), 0.3, 1e-9);  // as the figure of the end
  EXPECT_NEAR(value(1, 2, 3), 0.4, 1e-9);
}

TEST(ZoneHistories, AreLeftOutWhereNothingButTheEndIsKept) {
  EXPECT_TRUE(zone_histories(two_halves(), {heights("low", -1, 0)}).empty());
}

}  // namespace
}  // namespace diefill::process
