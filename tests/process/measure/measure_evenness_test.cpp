// Measures of evenness on powders whose solid fraction is a known function of the place.
#include <gtest/gtest.h>

#include <cmath>

#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/figures.h"
#include "process/measure/measure.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

/// A full ring of lattice sites 0.4 mm apart with the given solid fraction.
results::FillResult ring_with(const std::function<double(const Eigen::Vector3d&)>& value) {
  results::FillResult result;
  result.cavity = sample_ring();
  result.cavity.volume = 1e-6;
  result.powder = powder_of(lattice_in_ring(result.cavity, 4e-4, [](double) { return 6e-3; }), 4e-4);
  result.solid_fraction = fraction_of(result.powder, value);
  return result;
}

/// A box 20 mm long in x, which the shoe reaches first at its upper end.
results::FillResult box_with(const std::function<double(double)>& value_at_share) {
  results::FillResult result;
  result.cavity.lower_corner = {-10e-3, -2e-3, -6e-3};
  result.cavity.upper_corner = {10e-3, 2e-3, 0};
  result.cavity.volume = 1e-6;
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 12; ++k)
        places.emplace_back(-10e-3 + (i + 0.5) * kDiameter, -2e-3 + (j + 0.5) * kDiameter,
                            -6e-3 + (k + 0.5) * kDiameter);
  result.powder = powder_of(places);
  result.solid_fraction = fraction_of(result.powder, [&](const Eigen::Vector3d& place) {
    return value_at_share((10e-3 - place.x()) / 20e-3);
  });
  return result;
}

Figures measured(const results::FillResult& result, FigureMeasure measure) {
  Figures figures;
  measure(result, figures);
  return figures;
}

TEST(AzimuthalHarmonics, AreFoundWithAmplitudeAndAzimuth) {
  const auto ring = sample_ring();
  const auto result = ring_with([&](const Eigen::Vector3d& place) {
    const double azimuth = azimuth_of(ring, place) * kRadians;
    return 0.4 + 0.02 * std::cos(azimuth - 30 * kRadians) + 0.01 * std::cos(2 * (azimuth - 130 * kRadians));
  });
  const auto figures = measured(result, azimuthal_harmonics);
  EXPECT_NEAR(figures.at("solid_fraction_harmonic_1"), 0.02, 1e-12);
  EXPECT_NEAR(figures.at("solid_fraction_harmonic_1_azimuth_deg"), 30, 1e-8);
  EXPECT_NEAR(figures.at("solid_fraction_harmonic_2"), 0.01, 1e-12);
  EXPECT_NEAR(figures.at("solid_fraction_harmonic_2_azimuth_deg"), 130, 1e-8);
  EXPECT_TRUE(measured(result, travel_harmonics).empty());
}

TEST(AzimuthalHarmonics, AreNothingInAnEvenRingAndNoNumberInAnEmptyOne) {
  const auto even = measured(ring_with([](const Eigen::Vector3d&) { return 0.4; }), azimuthal_harmonics);
  EXPECT_NEAR(even.at("solid_fraction_harmonic_1"), 0, 1e-14);
  EXPECT_NEAR(even.at("solid_fraction_harmonic_2"), 0, 1e-14);
  auto empty = ring_with([](const Eigen::Vector3d&) { return 0.4; });
  empty.powder = powder_of({});
  empty.solid_fraction = {};
  EXPECT_TRUE(std::isnan(measured(empty, azimuthal_harmonics).at("solid_fraction_harmonic_1")));
}

// A third harmonic is none of the first two; the lattice of sites is not quite even round the circle.
TEST(AzimuthalHarmonics, LeaveHigherOnesOut) {
  const auto ring = sample_ring();
  const auto figures = measured(ring_with([&](const Eigen::Vector3d& place) {
                                  return 0.4 + 0.02 * std::cos(3 * azimuth_of(ring, place) * kRadians);
                                }),
                                azimuthal_harmonics);
  EXPECT_LT(figures.at("solid_fraction_harmonic_1"), 5e-4);
  EXPECT_LT(figures.at("solid_fraction_harmonic_2"), 5e-4);
}

TEST(TravelHarmonics, CountFromWhereTheShoeArrives) {
  const auto result = box_with([](double share) {
    return 0.4 + 0.03 * std::cos(std::numbers::pi * share) - 0.01 * std::cos(2 * std::numbers::pi * share);
  });
  const auto figures = measured(result, travel_harmonics);
  EXPECT_NEAR(figures.at("solid_fraction_along_travel_1"), 0.03, 1e-12);
  EXPECT_NEAR(figures.at("solid_fraction_along_travel_2"), -0.01, 1e-12);
  EXPECT_TRUE(measured(result, azimuthal_harmonics).empty());
  auto turned = result;  // a shoe that comes from the other side finds the far end dense
  turned.cavity.azimuth_zero = -Eigen::Vector3d::UnitX();
  EXPECT_NEAR(measured(turned, travel_harmonics).at("solid_fraction_along_travel_1"), -0.03, 1e-12);
}

// 12 layers: surface 5.75 mm above the floor, thirds end at 1.917 and 3.833 mm, the top 1 mm is not counted.
// Lower third: 4 layers of 0.3; upper: the layers at 4.25 and 4.75 mm of 0.5.
TEST(TopToBottom, IsTheDifferenceOfThirds) {
  auto result = box_with([](double) { return 0.4; });
  for (std::size_t k = 0; k < result.powder.position.size(); ++k) {
    const double height = result.powder.position[k].z() + 6e-3;
    const double value = height < 2e-3 ? 0.3 : height > 4e-3 ? 0.5 : 0.4;
    result.solid_fraction.solid_fraction[k] = value;
    result.solid_fraction.cell_volume[k] = result.powder.grain_solid_volume / value;
  }
  EXPECT_NEAR(measured(result, top_to_bottom).at("solid_fraction_top_minus_bottom"), 0.2, 1e-12);
}

// A wave much longer than the averaging width keeps exp(-(k sigma)^2 / 2) of its amplitude.
TEST(FieldEvenness, IsTheSpreadOfTheAveragedField) {
  auto result = box_with([](double share) { return 0.4 + 0.03 * std::cos(2 * std::numbers::pi * share); });
  results::SectionField section;
  section.field.averaging_width = 5e-4;
  result.sections.push_back(section);
  // Solid fraction is the plain variance of a cosine over whole periods: 0.03 / sqrt(2), a little smoothed.
  EXPECT_NEAR(measured(result, field_evenness).at("solid_fraction_field_std"), 0.03 / std::sqrt(2.0), 3e-4);
  result.sections.clear();
  EXPECT_TRUE(std::isnan(measured(result, field_evenness).at("solid_fraction_field_std")));
}

TEST(FillHeight, IsTheMeanLevel) {
  // Heights of the topmost sphere tops: 6 mm everywhere; without the upper half of the far end, 3 mm there.
  // Of 121 nodes along the box 61 stand in the near half and one more within a grain diameter of its spheres.
  auto box = box_with([](double) { return 0.4; });
  EXPECT_NEAR(measured(box, fill_height).at("fill_height_mm"), 6, 1e-9);
  std::vector<Eigen::Vector3d> places;
  for (const auto& place : box.powder.position)
    if (place.x() > 0 || place.z() < -3e-3) places.push_back(place);
  box.powder = powder_of(places);
  EXPECT_NEAR(measured(box, fill_height).at("fill_height_mm"), (62 * 6.0 + 59 * 3) / 121, 1e-9);
  auto ring = ring_with([](const Eigen::Vector3d&) { return 0.4; });
  ring.profiles.push_back(
      {"fill level", "mm", "azimuth", "deg", {45, 135, 225, 315}, {4, 6, std::nan(""), 2}});
  EXPECT_NEAR(measured(ring, fill_height).at("fill_height_mm"), 3, 1e-12);
}

TEST(Figures, AreAllMeasuredWhereThereIsACavity) {
  auto result = box_with([](double) { return 0.4; });
  measure_figures(result);
  for (const char* name : {"solid_fraction_top_minus_bottom", "solid_fraction_along_travel_1",
                           "solid_fraction_field_std", "fill_height_mm"})
    EXPECT_TRUE(result.figures.contains(name)) << name;
  auto bed = result;
  bed.figures.clear();
  bed.cavity.volume = 0;
  measure_figures(bed);
  EXPECT_TRUE(bed.figures.empty());
}

}  // namespace
}  // namespace diefill::process
