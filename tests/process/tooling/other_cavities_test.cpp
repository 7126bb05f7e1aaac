#include "process/tooling/examination/other_cavities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "process/measure/choose_cavity.h"
#include "process/measure/measure.h"
#include "process/results/cavity_rows.h"
#include "process/results/figure_table.h"
#include "process/results/no_value.h"
#include "process/tooling/tooling.h"

namespace diefill::process {
namespace {

geometry::Cavity box_cavity(double x) {
  geometry::Cavity cavity;
  cavity.found = true;
  cavity.box.include(Eigen::Vector3d(x, 0, -0.01));
  cavity.box.include(Eigen::Vector3d(x + 0.01, 0.01, 0));
  cavity.volume = 1e-6;
  cavity.axis_origin = {x + 0.005, 0.005, 0};
  return cavity;
}

constexpr std::size_t kInFirst = 48, kInSecond = 30;

/// Columns of six grains in boxes at x = 0 (eight columns) and x = 0.02 (five), each cell eight times its
/// grain.
results::FillResult filled_boxes() {
  results::FillResult result;
  result.powder.grain_diameter = 1e-3;
  result.powder.grain_mass = 2e-6;
  result.powder.grain_solid_volume = 1e-9;
  for (const double x : {0.003, 0.007, 0.025})
    for (int column = 0; column < (x < 0.01 ? 4 : 5); ++column)
      for (int k = 0; k < 6; ++k)
        result.powder.position.emplace_back(x, 0.001 + 0.0017 * column, -0.0095 + 1e-3 * k);
  const std::size_t grains = result.powder.position.size();
  result.solid_fraction.solid_fraction.assign(grains, 0.125);
  result.solid_fraction.cell_volume.assign(grains, 8e-9);
  result.solid_fraction.open.assign(grains, 0);
  result.solid_fraction.in_cavity.assign(grains, 0);
  std::fill_n(result.solid_fraction.in_cavity.begin(), kInFirst, 1);
  return result;
}

TEST(OtherCavities, TellWhatTheyHold) {
  results::FillResult result = filled_boxes();
  add_other_cavities(result, {box_cavity(0.02)});
  EXPECT_NEAR(result.figures.at("cavity_2_filled_mass_kg"), kInSecond * 2e-6, 1e-18);
  EXPECT_NEAR(result.figures.at("cavity_2_solid_fraction"), 0.125, 1e-12);
  EXPECT_EQ(result.figures.at("cavity_2_volume_m3"), 1e-6);
  for (const auto& [name, value] : result.figures) EXPECT_NE(results::find_figure(name), nullptr) << name;
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings[0].find("2 cavities"), std::string::npos);
  const auto rows = results::cavity_rows(result);
  EXPECT_TRUE(rows.empty());  // the first has no volume here
  result.cavity.volume = 1e-6;
  ASSERT_EQ(results::cavity_rows(result).size(), 2U);
  EXPECT_NEAR(results::cavity_rows(result)[1].place.x(), 0.025, 1e-12);
  EXPECT_NEAR(results::cavity_rows(result)[1].solid_fraction, 0.125, 1e-12);
  // Figures of the cavity that maps are of stay as they are.
  EXPECT_EQ(std::count(result.solid_fraction.in_cavity.begin(), result.solid_fraction.in_cavity.end(), 1),
            kInFirst);
}

TEST(OtherCavities, CanBeChosenForMapsAndSummary) {
  results::FillResult result = filled_boxes();
  result.title = "Twin die";
  result.cavity.lower_corner = {0, 0, -0.01};
  result.cavity.upper_corner = {0.01, 0.01, 0};
  for (std::size_t k = kInFirst; k < kInFirst + kInSecond; ++k) {
    result.solid_fraction.solid_fraction[k] = 0.25;
    result.solid_fraction.cell_volume[k] = 4e-9;
  }
  add_other_cavities(result, {box_cavity(0.02)});
  const double figure = result.figures.at("cavity_2_solid_fraction");

  choose_cavity(result, 1);
  EXPECT_EQ(result.title, "Twin die");
  EXPECT_EQ(result.solid_fraction.in_cavity[0], 1);
  choose_cavity(result, 2);
  EXPECT_EQ(result.title, "Twin die, cavity 2");
  EXPECT_EQ(result.cavity.lower_corner.x(), 0.02);
  EXPECT_EQ(result.solid_fraction.in_cavity[0], 0);
  EXPECT_EQ(result.solid_fraction.in_cavity[kInFirst], 1);
  EXPECT_EQ(result.summary.mean, figure);
  EXPECT_NEAR(filled_mass(result.powder, result.solid_fraction), kInSecond * 2e-6, 1e-18);
}

TEST(OtherCavities, ThatTheDieDoesNotHaveCannotBeChosen) {
  results::FillResult result = filled_boxes();
  EXPECT_THROW(choose_cavity(result, 2), std::invalid_argument);
  EXPECT_THROW(choose_cavity(result, 0), std::invalid_argument);
  EXPECT_EQ(result.solid_fraction.in_cavity[0], 1);
}

TEST(OtherCavities, CountInWhatMotionsAndPlansTakeForTheCavity) {
  Tooling tooling;
  tooling.cavity = box_cavity(0);
  tooling.cavity.narrowest_width = 6e-3;
  tooling.other_cavities = {box_cavity(0.02)};
  tooling.other_cavities[0].narrowest_width = 4e-3;
  const geometry::Cavity all = tooling.all_cavities();
  EXPECT_EQ(all.volume, 2e-6);
  EXPECT_EQ(all.narrowest_width, 4e-3);
  EXPECT_EQ(all.box.lower.x(), 0);
  EXPECT_EQ(all.box.upper.x(), 0.03);
}

TEST(OtherCavities, AreMeasuredAsTheFirstAndKeepItsFigures) {
  results::FillResult result = filled_boxes();
  result.cavity.volume = 1e-6;
  result.figures["fill_ratio"] = 0.9;
  add_other_cavities(result, {box_cavity(0.02)}, [](results::FillResult& other) {
    other.figures["fill_ratio"] = 0.7;
    other.maps.emplace_back();
    other.profiles.push_back({"fill level", "mm", "", "", {}, {}});
    results::add_statement(other, results::kVerdictTopic, results::verdict_name(1), "70 % full");
    results::set_no_value(other, "fill_height_mm", "why");
  });
  EXPECT_EQ(result.figures.at("fill_ratio"), 0.9);
  EXPECT_EQ(result.figures.at("cavity_2_fill_ratio"), 0.7);
  EXPECT_EQ(results::cavity_rows(result).at(1).verdict, "70 % full");
  EXPECT_EQ(results::reason_for(result, "cavity_2_fill_height_mm"), "why");
  EXPECT_TRUE(result.maps.empty());
  ASSERT_EQ(result.profiles.size(), 1U);
  EXPECT_EQ(result.profiles[0].quantity, "fill level, cavity 2");
}

TEST(OtherCavities, OneCavityIsNotWorthAWord) {
  results::FillResult result = filled_boxes();
  add_other_cavities(result, {});
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_TRUE(result.figures.empty());
}

}  // namespace
}  // namespace diefill::process
