// Results compared with measured profiles and maps whose differences are known.
#include "process/measured_data/compare_with_measured.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/input/scene_error.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

/// A ring of 20 mm depth whose level rises with the azimuth, and a map that rises with azimuth and height.
results::FillResult ring() {
  results::FillResult result;
  result.cavity.is_ring = true;
  result.cavity.lower_corner = {-0.01, -0.01, -0.02};
  result.cavity.upper_corner = {0.01, 0.01, 0};
  result.scene_text =
      "[[measure.zone]]\nname = \"flange\"\nheights = [\"-8 mm\", \"0 mm\"]\n"
      "[[measure.zone]]\nname = \"hub\"\nouter_radius = \"5 mm\"\n";
  results::Profile level{"fill level", "mm", "azimuth", "deg", {}, {}};
  for (int k = 0; k < 36; ++k) {
    level.x.push_back(5 + 10 * k);
    level.y.push_back(10 + 0.01 * level.x.back());
  }
  result.profiles = {level};
  results::Field2D map{"solid fraction", "azimuth", "deg", "height", "mm", {0, 180, 360}, {0, 10, 20}, {}, 0};
  for (const double height : map.second)
    for (const double azimuth : map.first) map.value.push_back(0.3 + 1e-4 * azimuth + 1e-3 * height);
  result.maps = {map};
  return result;
}

class CompareWithMeasured : public testing::Test {
 protected:
  results::MeasuredComparison against(const std::string& csv,
                                      const results::FillResult& result = ring()) const {
    folder_.write("level.csv", csv);
    return compare_with_measured(read_measured_files({(folder_.path() / "level.csv").string()}).front(),
                                 result);
  }
  std::string complaint(const std::string& csv) const {
    try {
      against(csv);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no complaint";
  }
  support::TemporaryFolder folder_;
};

const results::MeasuredZone& zone(const results::MeasuredComparison& comparison, const std::string& name) {
  for (const auto& each : comparison.zones)
    if (each.name == name) return each;
  throw std::out_of_range("no zone " + name);
}

TEST_F(CompareWithMeasured, AProfileGivesDifferenceAndCorrelationInAllAndByQuarters) {
  // 1 mm below the simulated level in the first half, 2 mm below it in the second; in cm.
  const auto comparison =
      against("azimuth [deg], fill level [cm]\n45, 0.945\n135, 1.035\n225, 1.025\n315, 1.115\n");
  ASSERT_EQ(comparison.simulated.size(), 4U);
  EXPECT_NEAR(comparison.simulated[1], 1.135, 1e-9);
  EXPECT_TRUE(std::isnan(comparison.deviation[0]));
  const auto& all = zone(comparison, "all");
  EXPECT_EQ(all.points, 4U);
  EXPECT_NEAR(all.simulated - all.measured, 0.15, 1e-9);
  EXPECT_NEAR(all.rms, std::sqrt((0.01 + 0.01 + 0.04 + 0.04) / 4), 1e-9);
  EXPECT_GT(all.correlation, 0.8);
  EXPECT_LT(all.correlation, 1);
  EXPECT_NEAR(zone(comparison, "azimuth 90 to 180 deg").rms, 0.1, 1e-9);
  EXPECT_NEAR(zone(comparison, "azimuth 270 to 360 deg").rms, 0.2, 1e-9);
}

/// A cavity from x = -10 to 10 mm; the shoe arrives at x = 10 mm, where the level is 12 mm, 10 mm at the end.
results::FillResult slot() {
  results::FillResult result;
  result.cavity.lower_corner = {-0.01, -0.002, -0.02};
  result.cavity.upper_corner = {0.01, 0.002, 0};
  result.cavity.azimuth_zero = Eigen::Vector3d::UnitX();
  result.profiles = {
      {"fill level", "mm", "distance along the shoe's travel", "mm", {0, 10, 20}, {12, 11, 10}}};
  return result;
}

TEST_F(CompareWithMeasured, PositionsAlongTheTravelOfTheShoeAreDistancesOnIt) {
  const auto comparison = against("x mm,fill level mm\n-10,10\n5,11.5\n10,12\n", slot());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(comparison.simulated[k], comparison.measured[k], 1e-9) << k;
  EXPECT_NEAR(against("x [m],fill level over x [mm]\n-0.01,9\n0.01,9\n", slot()).simulated[0], 10, 1e-9);
  results::FillResult from_the_other_end = slot();
  from_the_other_end.cavity.azimuth_zero *= -1;
  EXPECT_NEAR(against("x mm,fill level mm\n-10,9\n10,9\n", from_the_other_end).simulated[0], 12, 1e-9);
  EXPECT_THROW(against("y mm,fill level mm\n-1,9\n1,9\n", slot()), SceneError);
}

TEST_F(CompareWithMeasured, TheTableThatAComparisonLeavesIsMeasuredDataAgain) {
  const std::string head = "azimuth [deg], fill level [mm]";
  for (const std::string& csv :
       {head + "\n45, 9.45\n135, 10.35\n", head + ", deviation [mm]\n45, 9.45, 0.3\n135, 10.35, 0.4\n"}) {
    const auto first = against(csv);
    results::write_measured_comparison(folder_.path(), first);
    const auto again = compare_with_measured(
        read_measured_files({(folder_.path() / "measured_level.csv").string()}).front(), ring());
    EXPECT_EQ(again.quantity, "fill level");
    EXPECT_EQ(again.measured, first.measured);
    EXPECT_EQ(again.simulated, first.simulated);
    EXPECT_EQ(std::isnan(again.deviation[0]), std::isnan(first.deviation[0]));
  }
}

TEST_F(CompareWithMeasured, AzimuthsFromMinus180DegreesAreThoseOfTheSameSectors) {
  // The level of the sector at 225 and at 315 degrees, then in the closed map at 270 degrees.
  const auto profile = against("azimuth [deg], fill level [mm]\n-135, 12.25\n-45, 13.15\n45, 10.45\n");
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(profile.simulated[k], profile.measured[k], 1e-9) << k;
  const auto map = against("azimuth [deg], height [mm], solid fraction [1]\n-90, 10, 0.337\n90, 10, 0.319\n");
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(map.simulated[k], map.measured[k], 1e-9) << k;
}

TEST_F(CompareWithMeasured, AzimuthsInAnyUnitHaveQuarters) {
  for (const std::string data : {"[°], fill level [mm]\n-45, 13\n45, 10\n135, 11\n",
                                 "[rad], fill level [mm]\n-0.7854, 13\n0.7854, 10\n2.356, 11\n"}) {
    const auto comparison = against("azimuth " + data);
    EXPECT_EQ(zone(comparison, "azimuth 0 to 90 deg").measured, 10) << data;
    EXPECT_EQ(zone(comparison, "azimuth 90 to 180 deg").measured, 11) << data;
    EXPECT_EQ(zone(comparison, "azimuth 270 to 360 deg").measured, 13) << data;
  }
}

TEST_F(CompareWithMeasured, DataThatAreConstantHaveNoCorrelation) {
  std::string csv = "azimuth [deg], fill level [mm]\n";
  for (int k = 0; k < 29; ++k) csv += std::to_string(5 + 10 * k) + ", 15.1\n";
  EXPECT_TRUE(std::isnan(zone(against(csv), "all").correlation));
}

TEST_F(CompareWithMeasured, AMisspeltProfileIsNamedWithTheNearest) {
  EXPECT_NE(complaint("azimuth [deg], fill levl [mm]\n45, 9\n")
                .find("level.csv:1:16: found \"fill levl\", of which the result has no profile; did you mean "
                      "\"fill level\"?"),
            std::string::npos)
      << complaint("azimuth [deg], fill levl [mm]\n45, 9\n");
}

TEST_F(CompareWithMeasured, AMapHasTheZonesOfTheSceneThatItsCoordinatesTellApart) {
  std::string csv = "azimuth [deg], height [mm], solid fraction [1], deviation [1]\n";
  for (const double height : {2.0, 10.0, 18.0})
    for (const double azimuth : {90.0, 270.0})
      csv += std::to_string(azimuth) + ", " + std::to_string(height) + ", " +
             std::to_string(0.3 + 1e-4 * azimuth + 1e-3 * height + (height > 12 ? 0.01 : 0)) + ", 0.002\n";
  const auto comparison = against(csv);
  EXPECT_TRUE(comparison.is_map());
  EXPECT_NEAR(comparison.deviation[3], 0.002, 1e-12);
  // 8 mm below the rim is 12 mm above the floor: the flange holds the two upper places.
  EXPECT_EQ(zone(comparison, "flange").points, 2U);
  EXPECT_NEAR(zone(comparison, "flange").rms, 0.01, 1e-6);
  EXPECT_NEAR(zone(comparison, "height 2 to 7.333 mm").rms, 0, 1e-6);
  EXPECT_THROW(zone(comparison, "hub"), std::out_of_range);  // a radius, which the map does not have
}

TEST_F(CompareWithMeasured, PlacesWithoutASimulatedValueDoNotCount) {
  const auto comparison =
      against("azimuth [deg], height [mm], solid fraction [1]\n90, 10, 0.319\n90, 25, 0.5\n180, 10, 0.328\n");
  EXPECT_TRUE(std::isnan(comparison.simulated[1]));
  EXPECT_EQ(zone(comparison, "all").points, 2U);
  EXPECT_TRUE(std::isnan(zone(comparison, "all").correlation));
}

TEST_F(CompareWithMeasured, FaultsAreNamedInOneLine) {
  EXPECT_NE(complaint("azimuth [deg], level [mm]\n45, 9\n").find("it has \"fill level over azimuth\""),
            std::string::npos);
  EXPECT_NE(complaint("azimuth [deg], fill level [g]\n45, 9\n").find("level.csv"), std::string::npos);
  EXPECT_NE(complaint("azimuth [deg], fill level\n45, 9\n").find("has no unit"), std::string::npos);
  EXPECT_NE(complaint("azimuth [deg], fill level [mm]\n45, 9\n45, 8\n").find("given twice"),
            std::string::npos);
  EXPECT_NE(complaint("azimuth [deg], fill level [mm]\n45, 9, 1\n").find("found 3 values, expected 2"),
            std::string::npos);
  EXPECT_NE(
      complaint("azimuth [deg], fill level [mm], deviation [mm]\n45, 9, 0\n").find("standard deviation is 0"),
      std::string::npos);
  EXPECT_NE(
      complaint("azimuth [deg], height [mm], solid fraction [1]\n90, 30, 0.3\n").find("none of its 1 places"),
      std::string::npos);
}

TEST_F(CompareWithMeasured, ColumnsAreKnownByTheirNamesInAnyOrder) {
  const auto comparison = against(
      "solid fraction [%], deviation [%], height [mm], Azimuth [deg]\n31.9, 1, 10, 90\n32.8, 1, 10, 180\n");
  EXPECT_EQ(comparison.first_name, "azimuth");
  EXPECT_EQ(comparison.second, (std::vector<double>{10, 10}));
  EXPECT_NEAR(comparison.simulated[0], 31.9, 1e-9);
  EXPECT_NEAR(zone(comparison, "all").rms, 0, 1e-9);
}

TEST_F(CompareWithMeasured, ColumnsOfOtherNamesAreRefused) {
  const auto expect = [&](const std::string& csv, const std::string& part) {
    const std::string said = complaint(csv);
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  expect("depth below rim [mm], solid fraction [1]\n2, 0.3\n",
         "level.csv:1:1: column of places: found \"depth below rim\", allowed: \"azimuth\", \"x\"");
  expect("heigt [mm], solid fraction [1]\n2, 0.3\n", "did you mean \"height\"?");
  expect(
      "x [mm], y [mm], solid fraction [1]\n2, 1, 0.3\n",
      "found places as \"x\" and \"y\", but the solid fraction of the result runs over \"azimuth [deg]\" and "
      "\"height [mm]\"");
  expect("x [mm], x [mm], solid fraction [1]\n2, 1, 0.3\n", "level.csv:1:9: found column x twice");
  expect("height [mm], fill level [mm]\n2, 3\n",
         "places of fill level: found \"height\", allowed: \"azimuth\"");
  expect("azimuth [s], fill level [mm]\n2, 3\n",
         "level.csv:1:1: found places in \"s\", allowed: a unit such as "
         "\"deg\"");
  expect("azimuth [deg], fill level [g]\n2, 3\n", "level.csv:1:16: found \"fill level [g]\"");
  expect("fill level [mm], deviation [mm]\n2, 3\n", "found 0 columns of places");
  expect("azimuth [deg], height [mm]\n2, 3\n", "found no column of values");
}

TEST_F(CompareWithMeasured, ImpossibleValuesAreRefusedWithTheirLine) {
  const std::string head = "azimuth [deg], height [mm], solid fraction [1]\n90, 10, 0.3\n";
  EXPECT_NE(
      complaint(head + "180, 10, 35.3\n")
          .find("level.csv:3: found solid fraction 35.3, allowed: 0 to 1, the range of possible values"),
      std::string::npos)
      << complaint(head + "180, 10, 35.3\n");
  for (const char* value : {"-0.3", "nan", "1e999", "1.0001"})
    EXPECT_NE(complaint(head + "180, 10, " + value + "\n").find("level.csv:3"), std::string::npos) << value;
  EXPECT_NE(complaint("azimuth [deg], fill level [mm]\n45, -9\n").find("found fill level -9 mm"),
            std::string::npos);
}

TEST_F(CompareWithMeasured, TwoFilesOfOneNameAreRefused) {
  folder_.write("a.csv", "azimuth [deg], fill level [mm]\n45, 9\n");
  const std::string file = (folder_.path() / "a.csv").string();
  EXPECT_THROW(read_measured_files({file, file}), SceneError);
}

}  // namespace
}  // namespace diefill::process
