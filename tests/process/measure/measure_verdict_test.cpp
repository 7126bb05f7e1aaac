// What a filling means for the press: real mass, fill ratio, where it is loose, and what too few grains tell.
#include <gtest/gtest.h>

#include <cmath>

#include "process/measure/fields/box_map.h"
#include "process/measure/figures/enough_grains.h"
#include "process/measure/figures/figures.h"
#include "process/measure/figures/real_mass.h"
#include "process/measure/figures/verdict.h"
#include "process/measure/measure.h"
#include "process/results/cavity_rows.h"
#include "process/results/no_value.h"
#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

using Fraction = std::function<double(const Eigen::Vector3d&)>;

constexpr int kColumns = 20, kRows = 8;

/// A box of 10 x 4 x 6 mm that the shoe reaches first at its upper end of x, filled to `layers` of 12.
results::FillResult box(const Fraction& value, int layers = 12, int columns = kColumns) {
  results::FillResult result;
  result.cavity.lower_corner = {-5e-3, -2e-3, -6e-3};
  result.cavity.upper_corner = {5e-3, 2e-3, 0};
  result.cavity.volume = 240e-9;
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < kRows; ++j)
      for (int k = 0; k < layers; ++k)
        places.emplace_back(-5e-3 + (i + 0.5) * kDiameter, -2e-3 + (j + 0.5) * kDiameter,
                            -6e-3 + (k + 0.5) * kDiameter);
  result.powder = powder_of(places);
  result.solid_fraction = fraction_of(result.powder, value);
  result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
  result.figures["shoe_speed_m_s"] = 0.2;
  return result;
}

/// The box as a run measures it, of powder whose bed has a solid fraction of 0.5.
void measure(results::FillResult& result, double apparent_density = 3000, const PowderBed& bed = {0.5, 500}) {
  result.profiles = {fill_level_along_travel(result)};
  add_real_mass(result, {apparent_density, 7870}, bed);
  measure_figures(result);
  withhold_poor_figures(result);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// 1,920 spheres of 0.5 mm in 240 mm^3: pi / 6 of it, 1.0472 of a bed of 0.5.
TEST(RealMass, FollowsFromTheFillRatioAndTheApparentDensity) {
  auto result = box([](const auto&) { return 0.5; });
  measure(result);
  EXPECT_NEAR(result.figures.at("cavity_solid_fraction"), std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(result.figures.at("fill_ratio"), std::numbers::pi / 3, 1e-12);
  EXPECT_NEAR(result.figures.at("full_die_mass_kg"), 0.72e-3, 1e-15);
  EXPECT_NEAR(result.figures.at("expected_mass_kg"), 0.72e-3 * std::numbers::pi / 3, 1e-15);
  EXPECT_EQ(result.figures.at("apparent_density_is_estimate"), 0);
  EXPECT_FALSE(result.figures.contains("estimated_mass_kg"));
}

TEST(RealMass, IsEstimatedFromTheMetalWhereNobodyHasWeighedThePowder) {
  auto result = box([](const auto&) { return 0.5; });
  measure(result, 0);
  EXPECT_NEAR(result.figures.at("apparent_density_kg_m3"), 0.5 * 7870, 1e-9);
  EXPECT_EQ(result.figures.at("apparent_density_is_estimate"), 1);
  EXPECT_NEAR(result.figures.at("expected_mass_kg"), 240e-9 * std::numbers::pi / 6 * 7870, 1e-12);
  EXPECT_TRUE(has(verdict(result), "about 0.99 g, a die full at apparent density holds 0.94 g"))
      << verdict(result);
  EXPECT_TRUE(results::cavity_rows(result).at(0).estimate);
}

TEST(RealMass, HasNoFillRatioWithoutABedAndSaysWhy) {
  auto result = box([](const auto&) { return 0.5; });
  measure(result, 0, {std::nan(""), 9});
  EXPECT_TRUE(std::isnan(result.figures.at("fill_ratio")));
  EXPECT_TRUE(has(results::reason_for(result, "fill_ratio"),
                  "only 9 grains lie two diameters below the surface there; 20 are needed"));
  EXPECT_EQ(results::reason_for(result, "apparent_density_kg_m3"), "unknown: set powder.apparent_density");
  EXPECT_NEAR(result.figures.at("estimated_mass_kg"), 240e-9 * std::numbers::pi / 6 * 7870, 1e-12);
  EXPECT_TRUE(has(verdict(result), "holds about 0.99 g; fill ratio unknown")) << verdict(result);
}

TEST(PowderBed, LeavesOutAllCavitiesAndBedsOfFewGrains) {
  auto result = box([](const auto&) { return 0.4; });
  EXPECT_EQ(powder_bed(result, {result.cavity}).grains, 0U);
  EXPECT_TRUE(std::isnan(powder_bed(result, {result.cavity}).solid_fraction));
  results::CavityState half = result.cavity;
  half.upper_corner.x() = 0;
  const PowderBed bed = powder_bed(result, {half});
  EXPECT_GT(bed.grains, 500U);
  EXPECT_NEAR(bed.solid_fraction, 0.4, 1e-12);
}

TEST(Verdict, LeadsWithMassAndFindsTheLooseEnd) {
  auto result = box([](const Eigen::Vector3d& place) { return place.x() < -2e-3 ? 0.3 : 0.4; });
  measure(result);
  const std::string text = verdict(result);
  EXPECT_TRUE(text.starts_with("full (105 %): 0.754 g")) << text;
  EXPECT_TRUE(has(text, "loosest where the shoe leaves (solid fraction 0.3")) << text;
  EXPECT_FALSE(has(text, "below the fill plane")) << text;
  EXPECT_FALSE(has(text, "too few grains")) << text;
  result.cavity.azimuth_zero = -Eigen::Vector3d::UnitX();
  EXPECT_TRUE(has(verdict(result), "loosest where the shoe arrives"));
  result.figures["shoe_speed_m_s"] = std::nan("");
  result.cavity.azimuth_zero = Eigen::Vector3d::UnitX();
  EXPECT_TRUE(has(verdict(result), "loosest at the end towards -x")) << verdict(result);
}

TEST(Verdict, FindsTheLooseTopAndTheLowSurface) {
  auto result = box([](const Eigen::Vector3d& place) { return place.z() < -4e-3 ? 0.3 : 0.4; }, 9);
  measure(result);
  const std::string text = verdict(result);
  EXPECT_TRUE(text.starts_with("79 % full: 0.565 g of the 0.72 g")) << text;
  EXPECT_TRUE(has(text, "loosest at the bottom")) << text;
  EXPECT_TRUE(has(text, "surface 1.5 mm below the fill plane")) << text;
  EXPECT_FALSE(has(text, "lowest where")) << text;
}

// Where the shoe arrives, the upper third of x, stand two of twelve layers: none is two diameters deep.
TEST(Verdict, NamesThePartsWithTooFewGrainsToBeCompared) {
  const auto with_low_end = [](const Fraction& value) {
    auto result = box(value);
    std::vector<Eigen::Vector3d> places;
    for (const auto& at : result.powder.position)
      if (at.x() < 5e-3 / 3 || at.z() < -5e-3) places.push_back(at);
    result.powder = powder_of(places);
    result.solid_fraction = fraction_of(result.powder, value);
    result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
    measure(result);
    return verdict(result);
  };
  const std::string few = "; too few grains to judge the powder where the shoe arrives";
  const std::string loose = with_low_end([](const auto& at) { return at.x() < -2e-3 ? 0.3 : 0.4; });
  EXPECT_TRUE(has(loose, "loosest where the shoe leaves (solid fraction 0.3")) << loose;
  EXPECT_TRUE(has(loose, few)) << loose;
  const std::string even = with_low_end([](const auto&) { return 0.4; });
  EXPECT_TRUE(has(even, "no region significantly looser than the rest" + few)) << even;
}

TEST(Verdict, SaysNothingOfPlacesWithinTheScatter) {
  int n = 0;
  auto result = box([&](const Eigen::Vector3d&) { return ++n % 2 == 0 ? 0.3 : 0.5; });
  measure(result);
  EXPECT_TRUE(has(verdict(result), "no region significantly looser than the rest")) << verdict(result);
}

TEST(Verdict, OfAnEmptyCavityIsThatItIsEmpty) {
  auto result = box([](const auto&) { return 0.4; }, 12, 0);
  measure(result);
  EXPECT_EQ(verdict(result), "empty: no powder in the cavity");
}

// Four columns of 12 layers, eight of which lie 2 d deep or more.
TEST(EnoughGrains, NoFigureStandsOnFewerThanTwenty) {
  auto result = box([](const auto&) { return 0.4; });
  std::vector<Eigen::Vector3d> few;
  for (int k = 0; k < 12; ++k) few.emplace_back(0, 0, -6e-3 + (k + 0.5) * kDiameter);
  result.powder = powder_of(few);
  result.solid_fraction = fraction_of(result.powder, [](const auto&) { return 0.4; });
  result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
  ASSERT_LT(result.summary.grains, kMinGrains);
  ASSERT_TRUE(std::isfinite(result.summary.mean));
  measure(result);
  EXPECT_TRUE(std::isnan(result.summary.mean));
  EXPECT_TRUE(std::isnan(result.summary.std));
  EXPECT_GT(result.summary.grains, 0U);
  for (const char* name : {"solid_fraction_top_minus_bottom", "solid_fraction_along_travel_1"}) {
    EXPECT_TRUE(std::isnan(result.figures.at(name))) << name;
    EXPECT_TRUE(has(results::reason_for(result, name), "60 are needed")) << name;
  }
  EXPECT_TRUE(has(results::reason_for(result, "solid_fraction"),
                  "two diameters below the surface in the cavity; 20 are needed"));
  EXPECT_TRUE(has(verdict(result), "too few grains to locate loose regions")) << verdict(result);
  EXPECT_TRUE(std::isfinite(result.figures.at("expected_mass_kg")));
}

TEST(EnoughGrains, AThirdWithoutGrainsIsTheReasonWhereThereAreEnough) {
  auto result = box([](const auto&) { return 0.4; });
  for (std::size_t k = 0; k < result.powder.position.size(); ++k)
    if (result.powder.position[k].z() > -3e-3) result.solid_fraction.open[k] = 1;
  result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
  measure(result);
  EXPECT_TRUE(std::isnan(result.figures.at("solid_fraction_top_minus_bottom")));
  EXPECT_TRUE(
      has(results::reason_for(result, "solid_fraction_top_minus_bottom"), "contains no grain to count"));
}

TEST(EnoughGrains, AmplitudesBeyondTheMeanAreNoFigures) {
  auto result = box([](const auto&) { return 0.4; });
  measure(result);
  EXPECT_TRUE(std::isfinite(result.figures.at("solid_fraction_along_travel_1")));
  result.figures["solid_fraction_along_travel_1"] = 37.92;
  withhold_poor_figures(result);
  EXPECT_TRUE(std::isnan(result.figures.at("solid_fraction_along_travel_1")));
  EXPECT_TRUE(std::isnan(result.figures.at("solid_fraction_along_travel_2")));
  EXPECT_FALSE(results::reason_for(result, "solid_fraction_along_travel_2").empty());
}

TEST(FillLevelAlongTravel, BeginsWhereTheShoeArrives) {
  // Nine of twelve layers, and only six in the far half of the travel, which is the lower end of x.
  auto result = box([](const auto&) { return 0.4; }, 9);
  std::vector<Eigen::Vector3d> places;
  for (const auto& at : result.powder.position)
    if (at.x() > 0 || at.z() < -3e-3) places.push_back(at);
  result.powder = powder_of(places);
  const auto level = fill_level_along_travel(result);
  EXPECT_NEAR(level.x.front(), 0, 1e-12);
  EXPECT_NEAR(level.x.back(), 10, 1e-12);
  EXPECT_NEAR(level.y.front(), 4.5, 1e-9);
  EXPECT_NEAR(level.y.back(), 3, 1e-9);
}

TEST(FillLevelAlongTravel, HasNoValueWhereThereIsNoPowderAcross) {
  auto result = box([](const auto&) { return 0.4; });
  std::vector<Eigen::Vector3d> places;
  for (const auto& at : result.powder.position)
    if (at.x() > 0) places.push_back(at);
  result.powder = powder_of(places);
  EXPECT_TRUE(std::isnan(fill_level_along_travel(result).y.back()));
}

}  // namespace
}  // namespace diefill::process
