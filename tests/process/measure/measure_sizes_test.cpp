// Measures of powder of several sizes: masses, volumes, contacts, and where large and small grains lie.
#include <gtest/gtest.h>

#include <numeric>

#include "process/measure/cavity_position.h"
#include "process/measure/coordination.h"
#include "process/measure/figures/figures.h"
#include "process/measure/figures/segregation.h"
#include "process/measure/measure.h"
#include "process/measure/volumes/partial_volumes.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

constexpr double kSmall = 1e-3, kLarge = 2e-3;  // m

/// Spheres of two sizes at these places; kinds by turns unless said otherwise.
results::PowderState two_sizes(const std::vector<Eigen::Vector3d>& places,
                               std::vector<std::uint8_t> kind = {}) {
  results::PowderState powder = powder_of(places, 1.5e-3);
  const double volume = std::numbers::pi / 6;
  powder.kinds.diameter = {kSmall, kLarge};
  powder.kinds.sphere_radius = {kSmall / 2, kLarge / 2};
  powder.kinds.mass = {1e-6, 8e-6};
  powder.kinds.solid_volume = {volume * kSmall * kSmall * kSmall, volume * kLarge * kLarge * kLarge};
  powder.kinds.material = {"powder", "powder"};
  for (std::size_t k = kind.size(); k < places.size(); ++k) kind.push_back(k % 2);
  powder.kind = std::move(kind);
  return powder;
}

/// A ring's powder on a lattice that fills it; `kind_at` from the place.
results::FillResult filled_ring(
    const std::function<std::uint8_t(const RingPosition&, std::size_t)>& kind_at) {
  results::FillResult result;
  result.cavity = sample_ring();
  result.cavity.volume = 1e-6;
  std::vector<Eigen::Vector3d> places;
  std::vector<std::uint8_t> kinds;
  for (double height = 1e-4; height < 6e-3; height += 4e-4)
    for (double radius = 8.3e-3; radius < 10.9e-3; radius += 5e-4)
      for (double azimuth = 1; azimuth < 360; azimuth += 5) {
        const RingPosition place{azimuth, radius, height};
        kinds.push_back(kind_at(place, places.size()));
        places.push_back(ring_point(result.cavity, place));
      }
  result.powder = two_sizes(places, kinds);
  result.solid_fraction = fraction_of(result.powder, [](const Eigen::Vector3d&) { return 0.4; });
  return result;
}

TEST(MeasureSizes, GrainsCountWithTheirOwnMassAndRadius) {
  const auto powder = two_sizes({{0, 0, 0}, {1.5e-3, 0, 0}, {2.6e-3, 0, 0}, {6e-3, 0, 0}});
  results::GrainSolidFraction fraction;
  fraction.in_cavity = {1, 1, 0, 1};
  EXPECT_NEAR(filled_mass(powder, fraction), 1e-6 + 8e-6 + 8e-6, 1e-18);
  // 0 and 1 touch at 0.5 + 1 mm; 1 and 2 would at 1.5 mm and are nearer; 3 is far.
  EXPECT_EQ(coordination_numbers(powder), (std::vector<int>{1, 2, 1, 0}));
  const auto apart = two_sizes({{0, 0, 0}, {1.5001e-3, 0, 0}});
  EXPECT_EQ(coordination_numbers(apart), (std::vector<int>{0, 0}));
  const auto volumes = cartesian_volumes(
      powder, {even_edges(-0.01, 0.01, 4), even_edges(-0.01, 0.01, 1), even_edges(-0.01, 0.01, 1)});
  double all = 0;
  for (const double value : volumes.value) all += value;
  EXPECT_NEAR(all, 2 * std::numbers::pi / 6 * (1e-9 + 8e-9), 1e-15);
}

TEST(MeasureSizes, SpheresOfClumpsStandApartAsTheirSizeSays) {
  auto powder = two_sizes({{0, 0, 0}, {0, 0, 1}});
  powder.sphere_radius = 0.5e-3;
  powder.sphere_offsets = {Eigen::Vector3d::Zero(), Eigen::Vector3d(1e-3, 0, 0)};
  const auto centres = powder.sphere_centres();
  EXPECT_NEAR(centres[1].x(), 1e-3, 1e-15);
  EXPECT_NEAR(centres[3].x(), 2e-3, 1e-15);
}

// Radical cells of a chain of large and small spheres in a periodic column: each cell as its radical planes
// cut it.
TEST(MeasureSizes, SolidFractionIsThatOfRadicalCells) {
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < 7; ++k) places.emplace_back(0, 0, 1.5e-3 * k);
  auto powder = two_sizes(places);
  const double side = 1.6e-3;
  powder.period = {side, side};
  const auto fraction = measure_solid_fraction(powder, {}, {});
  // The plane between radii r and R, a apart, is (a^2 + r^2 - R^2) / (2 a) from the small one.
  const double apart = 1.5e-3, near = (apart * apart + 0.25e-6 - 1e-6) / (2 * apart);
  for (std::size_t k = 1; k < 6; ++k) {
    const double height = 2 * (k % 2 == 0 ? near : apart - near);
    ASSERT_EQ(fraction.open[k], 0) << k;
    EXPECT_NEAR(fraction.cell_volume[k], height * side * side, 1e-9 * side * side * height) << k;
    EXPECT_NEAR(fraction.solid_fraction[k], powder.solid_volume_of(k) / (height * side * side), 1e-6) << k;
  }
}

TEST(Segregation, MixingIndexOfTheEndsIsZeroAndOne) {
  std::vector<double> values, weights;
  std::vector<std::size_t> apart, mixed;
  for (std::size_t k = 0; k < 4000; ++k) {
    const bool large = (k * 2654435761U >> 7) % 3 == 0;
    values.push_back(large ? 2 : 1);
    weights.push_back(large ? 8 : 1);
    apart.push_back(large ? 1 : 0);
    mixed.push_back((k * 40503U >> 3) % 8);
  }
  EXPECT_NEAR(mixing_index(values, weights, apart), 0, 2e-3);
  EXPECT_NEAR(mixing_index(values, weights, mixed), 1, 0.02);
  EXPECT_TRUE(std::isnan(mixing_index({1, 1}, {1, 1}, {0, 1})));
  EXPECT_TRUE(std::isnan(mixing_index({1, 2}, {1, 1}, {0, 0})));
}

TEST(Segregation, FiguresAndProfilesShowLargeGrainsOnTop) {
  const auto result = filled_ring([](const RingPosition& place, std::size_t) {
    return static_cast<std::uint8_t>(place.height > 3e-3 ? 1 : 0);
  });
  Figures figures;
  size_segregation(result, figures);
  EXPECT_NEAR(figures.at("mean_grain_diameter_top_minus_bottom_mm"), 1, 1e-9);
  EXPECT_NEAR(figures.at("mixing_index_height"), 0, 0.05);
  EXPECT_NEAR(figures.at("mixing_index_azimuth"), 1, 0.05);
  EXPECT_GT(figures.at("mean_grain_diameter_filled_mm"), 1.5);  // by mass
  const auto profiles = size_profiles(result);
  ASSERT_EQ(profiles.size(), 2U);
  EXPECT_EQ(profiles[0].x_name, "height");
  EXPECT_NEAR(profiles[0].y.front(), 1, 1e-9);
  EXPECT_NEAR(profiles[0].y.back(), 2, 1e-9);
  EXPECT_EQ(profiles[1].x.size(), 12U);
}

TEST(Segregation, PowdersThatLieInLayersAreSeparatedOverTheHeightOnly) {
  auto result = filled_ring([](const RingPosition& place, std::size_t) {
    return static_cast<std::uint8_t>(place.height > 3e-3 ? 1 : 0);
  });
  Figures figures;
  powder_segregation(result, figures);
  EXPECT_FALSE(figures.contains("powder_mixing_index_height")) << "both sizes are of one powder";
  result.powder.kinds.material = {"iron", "copper"};
  powder_segregation(result, figures);
  EXPECT_NEAR(figures.at("powder_mixing_index_height"), 0, 0.05);
  EXPECT_NEAR(figures.at("powder_mixing_index_azimuth"), 1, 0.05);
  EXPECT_NEAR(figures.at("first_powder_mass_share_all"), 1.0 / 9, 0.02);
}

TEST(Segregation, IsSeenRoundTheRing) {
  const auto result = filled_ring([](const RingPosition& place, std::size_t) {
    return static_cast<std::uint8_t>(place.azimuth < 180 ? 1 : 0);
  });
  Figures figures;
  size_segregation(result, figures);
  EXPECT_NEAR(figures.at("mixing_index_azimuth"), 0, 0.02);
  EXPECT_NEAR(figures.at("mixing_index_height"), 1, 0.05);
  const SizeField field(result.powder, 5e-4);
  EXPECT_NEAR(field.at(ring_point(result.cavity, {90, 9.5e-3, 3e-3})), 2, 1e-6);
  EXPECT_NEAR(field.at(ring_point(result.cavity, {270, 9.5e-3, 3e-3})), 1, 1e-6);
}

TEST(Segregation, OfOneSizeThereIsNone) {
  auto result = filled_ring([](const RingPosition&, std::size_t) { return std::uint8_t{0}; });
  result.powder.kind.clear();
  result.powder.kinds = {};
  Figures figures;
  size_segregation(result, figures);
  EXPECT_TRUE(figures.empty());
  EXPECT_TRUE(size_profiles(result).empty());
  EXPECT_THROW(SizeField(result.powder, 5e-4), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process
