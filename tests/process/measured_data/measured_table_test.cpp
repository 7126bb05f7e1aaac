// Measurements as a plant hands them over, and what is wrong with some.
#include "process/measured_data/measured_table.h"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"
#include "process/measured_data/deviations.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

class MeasuredCsv : public testing::Test {
 protected:
  MeasuredTable read(const std::string& text, std::size_t places = 1) const {
    folder_.write("data.csv", text);
    return read_measured_csv(folder_.path() / "data.csv", places);
  }
  /// The message, after the folder's name.
  std::string complaint(const std::string& text, std::size_t places = 1) const {
    try {
      read(text, places);
    } catch (const SceneError& error) {
      const std::string message = error.what();
      return message.substr(message.find("data.csv"));
    }
    return "no complaint";
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(MeasuredCsv, IsReadWithItsUnitsAndDeviationsInTheUnitOfTheValues) {
  const MeasuredTable table =
      read("# weighed on Monday\nspeed [m/s], mass [g], deviation [mg]\n0.1, 12.1, 300\n0.2, 8.4, 200\n");
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table.places[0].name, "speed");
  EXPECT_EQ(table.places[0].unit, "m/s");
  EXPECT_EQ(table.value.unit, "g");
  EXPECT_EQ(table.value.values, (std::vector<double>{12.1, 8.4}));
  EXPECT_EQ(table.deviation.unit, "g");
  EXPECT_NEAR(table.deviation.values[0], 0.3, 1e-12);
}

TEST_F(MeasuredCsv, SemicolonsQuotesAndCarriageReturnsOfSpreadsheetsAreTaken) {
  const MeasuredTable table = read("\"x [mm]\";\"level [mm]\";\"s [mm]\"\r\n1;2;0.5\r\n2;3;0.5\r\n");
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table.value.name, "level");
  EXPECT_EQ(table.value.values[1], 3);
}

// As tables of probes and of fits are written.
TEST_F(MeasuredCsv, UnitsMayStandBehindABlank) {
  const MeasuredTable table = read("x mm,fill level mm,standard deviation mm\n1,2,0.5\n2,3,0.5\n");
  EXPECT_EQ(table.places[0].name, "x");
  EXPECT_EQ(table.value.name, "fill level");
  EXPECT_EQ(table.value.unit, "mm");
  EXPECT_NE(complaint("z m,solid fraction,s [1]\n1,0.3,0.1\n")
                .find("data.csv:1:5: column \"solid fraction\" has no unit"),
            std::string::npos);
}

TEST_F(MeasuredCsv, MapsHaveTwoPlacesInAnyOrder) {
  const MeasuredTable table =
      read("azimuth [deg],height [mm],f [1],s [1]\n10,1,0.3,0.01\n0,1,0.31,0.01\n", 2);
  ASSERT_EQ(table.places.size(), 2U);
  EXPECT_EQ(table.places[1].name, "height");
}

TEST_F(MeasuredCsv, DeviationsStandInTheColumnThatIsCalledSo) {
  const MeasuredTable table = read("speed [m/s],deviation [g],mass [g]\n0.1,0.3,12\n");
  EXPECT_EQ(table.value.values[0], 12);
  EXPECT_EQ(table.deviation.values[0], 0.3);
}

TEST_F(MeasuredCsv, DeviationsMayBeCalledSoWithCapitals) {
  for (const char* name : {"Deviation", "Standard Deviation", "STANDARD DEVIATION"}) {
    const MeasuredTable table = read("Speed [m/s]," + std::string(name) + " [g],Mass [g]\n0.1,0.3,12\n");
    EXPECT_EQ(table.value.values[0], 12) << name;
    EXPECT_EQ(table.deviation.values[0], 0.3) << name;
  }
}

TEST_F(MeasuredCsv, DeviationsMayHaveOtherNamesOfThem) {
  for (const char* name : {"sigma", "\xCF\x83", "std", "std. dev.", "StdDev", "SD", "error", "standard error",
                           "uncertainty", "sigma_m"}) {
    const MeasuredTable table = read("speed [m/s]," + std::string(name) + " [g],mass [g]\n0.1,0.3,12\n");
    EXPECT_EQ(table.value.values[0], 12) << name;
    EXPECT_EQ(table.deviation.values[0], 0.3) << name;
  }
  // The name of a value that has one of these words in it, and a stress.
  EXPECT_EQ(read("sigma [kPa],s [kPa]\n12,0.3\n", 0).value.values[0], 12);
  EXPECT_EQ(read("standard mass [g],s [g]\n12,0.3\n", 0).value.values[0], 12);
  EXPECT_EQ(read("error of the level [mm],deviation [mm]\n12,0.3\n", 0).value.values[0], 12);
  EXPECT_NE(
      complaint("error [g],std [g]\n12,3\n", 0)
          .find("data.csv:1:11: found a second column of deviations, \"std\"; remove one of them, or call "
                "the right one \"deviation\""),
      std::string::npos)
      << complaint("error [g],std [g]\n12,3\n", 0);
  EXPECT_NE(complaint("mass [g],relative error [%]\n12,3\n", 0).find("in the unit of the values"),
            std::string::npos);
}

TEST_F(MeasuredCsv, DeviationsThatMostlyExceedTheValuesAreRemarkedOn) {
  EXPECT_EQ(remark_on_deviations(read("s [g],mass [g]\n0.3,12\n", 0)),
            "its deviation exceeds its value; check that value and deviation are not swapped");
  const std::string head = "speed [m/s],mass [g],s [g]\n";
  EXPECT_EQ(remark_on_deviations(read(head + "0.1,1,2\n0.2,-1,3\n0.3,9,3\n")).substr(0, 46),
            "2 of its 3 deviations exceed their values; che");
  EXPECT_EQ(remark_on_deviations(read(head + "0.1,1,2\n0.2,8,3\n")), "");
}

TEST_F(MeasuredCsv, AnEmptyUnitIsNone) {
  EXPECT_NE(
      complaint("fraction [],s [1]\n0.3,0.1\n", 0).find("data.csv:1:1: column \"fraction []\" has no unit"),
      std::string::npos);
}

TEST_F(MeasuredCsv, EachFaultIsNamedInOneLineWithItsLine) {
  EXPECT_EQ(complaint("speed,mass [g],s [g]\n1,2,3\n"),
            "data.csv:1:1: column \"speed\" has no unit; write one after the name, as in \"mass [g]\", or "
            "\"[1]\" for plain numbers");
  EXPECT_NE(complaint("speed [m/s],mass [grm],s [g]\n1,2,3\n").find("data.csv:1:13: column \"mass [grm]\""),
            std::string::npos);
  EXPECT_NE(
      complaint("speed [m/s],mass [g],s [mm]\n1,2,3\n").find("\"mm\" does not have the dimension of \"g\""),
      std::string::npos);
  const std::string head = "speed [m/s],mass [g],s [g]\n";
  EXPECT_EQ(complaint(head + "0.2,2,1\n0.1,3,1\n"),
            "data.csv:3: 0.1 follows 0.2; sort the points in rising order");
  EXPECT_EQ(complaint(head + "0.2,2,1\n0.2,3,1\n"),
            "data.csv:3: this place is given twice; give each place once, with the mean of its values");
  EXPECT_EQ(complaint(head + "0.2,2,1\n0.3,2,0\n"),
            "data.csv:3: the standard deviation is 0, allowed: more than 0; give the standard "
            "deviation of repeated measurements");
  EXPECT_NE(complaint(head + "0.2,2,-1\n").find("allowed: more than 0"), std::string::npos);
  EXPECT_EQ(complaint(head + "0.2,two,1\n"),
            "data.csv:2:5: found \"two\", expected a number with a decimal point");
  EXPECT_EQ(complaint(head + "0.2,nan,1\n"),
            "data.csv:2:5: found \"nan\", expected a number with a decimal point");
  EXPECT_NE(complaint(head + "0.2,2\n").find("data.csv:2: found 2 values, expected 3"), std::string::npos);
  EXPECT_NE(complaint("speed [m/s],mass [g],s [mm]\n1,2,3\n").find("data.csv:1:22: deviation in \"mm\""),
            std::string::npos);
  EXPECT_EQ(complaint("speed [m/s],speed [m/s],s [g]\n1,2,3\n"),
            "data.csv:1:13: found column speed twice; remove one of them");
  EXPECT_EQ(complaint(head), "data.csv: found no measured values; give a heading and a line for each value");
  EXPECT_EQ(complaint(""), "data.csv: found no measured values; give a heading and a line for each value");
}

TEST_F(MeasuredCsv, AzimuthsOfOneDirectionAreOnePlace) {
  const std::string twice = "this place is given twice (azimuths count modulo 360 deg)";
  const std::string head = "azimuth [deg],level [mm],s [mm]\n";
  EXPECT_NE(complaint(head + "0,2,1\n10,3,1\n360,3,1\n").find("data.csv:4: " + twice), std::string::npos);
  EXPECT_NE(complaint(head + "-10,2,1\n350,3,1\n").find(twice), std::string::npos);
  EXPECT_NE(complaint("azimuth [rad],level [mm],s [mm]\n0,2,1\n6.283185307179586,3,1\n").find(twice),
            std::string::npos);
  EXPECT_NE(complaint("azimuth [deg],height [mm],f [1],s [1]\n-90,1,0.3,0.1\n270,1,0.4,0.1\n", 2).find(twice),
            std::string::npos);
  EXPECT_EQ(read(head + "-180,2,1\n0,3,1\n179,3,1\n").size(), 3U);
  // Other coordinates do not return to where they began.
  EXPECT_EQ(read("speed [deg/s],level [mm],s [mm]\n0,2,1\n360,3,1\n").size(), 2U);
}

// As maps from 0 to 360 deg have it.
TEST_F(MeasuredCsv, TheEndOfAFullTurnThatRepeatsItsBeginningCountsOnce) {
  EXPECT_EQ(read("azimuth [deg],level [mm],s [mm]\n0,2,1\n180,3,1\n360,2,1\n").size(), 2U);
  const MeasuredTable map = read(
      "azimuth [deg],height [mm],f [1],s [1]\n0,1,0.3,0.1\n360,1,0.3,0.1\n90,1,0.2,0.1\n"
      "0,2,0.4,0.1\n360,2,0.4,0.1\n",
      2);
  EXPECT_EQ(map.value.values, (std::vector<double>{0.3, 0.2, 0.4}));
  EXPECT_EQ(map.lines, (std::vector<int>{2, 4, 5}));
}

TEST_F(MeasuredCsv, AzimuthsBeyondTwoTurnsAreRefused) {
  const std::string head = "azimuth [deg],level [mm],s [mm]\n";
  EXPECT_EQ(complaint(head + "1e9,2,1\n"),
            "data.csv:2: found azimuth 1e+09 deg, allowed: -360 to 720 deg; check the number and its unit");
  for (const char* azimuth : {"1e300", "-361", "721"})
    EXPECT_NE(complaint(head + azimuth + ",2,1\n").find("allowed: -360 to 720 deg"), std::string::npos);
}

TEST_F(MeasuredCsv, DeviationsFarFromTheValuesAreRefused) {
  const std::string head = "speed [m/s],angle [deg],s [deg]\n0.1,30,2\n";
  for (const std::string deviation : {"3e-300", "2.9e-8", "3.1e10", "3e300"})
    EXPECT_NE(complaint(head + "0.2,10," + deviation + "\n")
                  .find(" deg, allowed: 3e-08 to 3e+10 deg, which is 1e-9 to 1e9 times the largest value"),
              std::string::npos)
        << complaint(head + "0.2,10," + deviation + "\n");
  EXPECT_NE(complaint(head + "0.2,10,3e-300\n").find("data.csv:3: the standard deviation is 3e-300 deg"),
            std::string::npos);
  EXPECT_EQ(read("value [g],s [g]\n0,0.1\n", 0).size(), 1U);
  EXPECT_NE(complaint("value [g],s [g]\n0,3e-300\n", 0).find("allowed: 1e-30 to 1e+30 g"), std::string::npos);
}

/// What is said of an inline measurement.
std::string inline_complaint(const std::string& text, std::size_t places) {
  const toml::table parsed = toml::parse(text);
  TableReader reader(parsed, "powder.toml", "measurement");
  try {
    read_measured(reader, places);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(MeasuredInline, AFigureHasAValueAndADeviation) {
  const toml::table parsed = toml::parse("value = \"12.1 g\"\ndeviation = \"300 mg\"");
  TableReader reader(parsed, "powder.toml", "measurement");
  const MeasuredTable table = read_measured(reader, 0);
  EXPECT_EQ(table.value.values[0], 12.1);
  EXPECT_NEAR(table.deviation.values[0], 0.3, 1e-12);
}

TEST(MeasuredInline, ACurveHasListsAndOneDeviationServesAll) {
  const toml::table parsed =
      toml::parse("at = [\"100 mm/s\", \"0.2 m/s\"]\nvalues = [\"12 g\", \"8 g\"]\ndeviations = \"0.5 g\"");
  TableReader reader(parsed, "powder.toml", "measurement");
  const MeasuredTable table = read_measured(reader, 1);
  EXPECT_EQ(table.places[0].unit, "mm/s");
  EXPECT_NEAR(table.places[0].values[1], 200, 1e-9);
  EXPECT_EQ(table.deviation.values, (std::vector<double>{0.5, 0.5}));
}

TEST(MeasuredInline, AnglesThatASceneIsRunOverAreNoAzimuths) {
  const std::string lists =
      "at = [\"0 deg\", \"360 deg\", \"1080 deg\"]\nvalues = [\"0 g\", \"0 g\", \"8 g\"]\ndeviations = \"1 "
      "g\"\n";
  const toml::table parsed = toml::parse(lists + "over = \"step.1.angle\"");
  TableReader reader(parsed, "powder.toml", "measurement");
  EXPECT_EQ(read_measured(reader, 1).size(), 3U);
  EXPECT_NE(inline_complaint(lists, 1).find("azimuths count modulo 360 deg"), std::string::npos);
}

TEST(MeasuredInline, FaultsAreNamed) {
  EXPECT_NE(inline_complaint("value = \"12\"\ndeviation = \"1 g\"", 0).find("does not have the dimension of"),
            std::string::npos);
  EXPECT_NE(inline_complaint("value = \"12 g\"", 0).find("deviation"), std::string::npos);
  EXPECT_NE(
      inline_complaint("value = \"12 g\"\ndeviation = \"0 g\"", 0)
          .find("powder.toml:2:13: measurement.deviation: the standard deviation is 0, allowed: more than 0"),
      std::string::npos)
      << inline_complaint("value = \"12 g\"\ndeviation = \"0 g\"", 0);
  EXPECT_NE(inline_complaint(
                "at = [\"1 mm\", \"2 mm\"]\nvalues = [\"1 g\", \"2 g\"]\ndeviations = [\"1 g\", \"-1 g\"]", 1)
                .find("measurement.deviations: point 2: the standard deviation is -1"),
            std::string::npos);
  EXPECT_NE(inline_complaint("at = [\"1 mm\"]\nvalues = [\"1 g\", \"2 g\"]\ndeviations = \"1 g\"", 1)
                .find("as many entries"),
            std::string::npos);
  EXPECT_NE(inline_complaint("file = \"a.csv\"\nvalue = \"1 g\"", 0).find("remove one of the two"),
            std::string::npos);
  EXPECT_NE(
      inline_complaint("value = \"heavy\"\ndeviation = \"1 g\"", 0).find("does not begin with a number"),
      std::string::npos);
}

TEST(MeasuredInline, PlacesOutOfOrderAreNamedByTheirKey) {
  EXPECT_EQ(
      inline_complaint("at = [\"2 mm\", \"1 mm\"]\nvalues = [\"1 g\", \"2 g\"]\ndeviations = \"1 g\"", 1),
      "powder.toml:1:6: measurement.at: point 2: 1 follows 2; sort the points in rising order");
}

TEST(UnitConversion, TakesPlainNumbersPercentAndAngles) {
  EXPECT_NEAR(unit_factor("kg", "g"), 1000, 1e-9);
  EXPECT_NEAR(unit_factor("%", "1"), 0.01, 1e-15);
  EXPECT_NEAR(unit_factor("1", "%"), 100, 1e-12);
  EXPECT_EQ(unit_factor("", "-"), 1);
  EXPECT_NEAR(unit_factor("deg", "rad"), 3.14159265358979 / 180, 1e-12);
  EXPECT_NEAR(unit_factor("g/mm", "kg/m"), 1, 1e-12);
  EXPECT_THROW(unit_factor("g", "mm"), UnitError);
  EXPECT_THROW(unit_factor("Hz", "s"), UnitError);
  EXPECT_THROW(unit_factor("deg", "1"), UnitError);
  EXPECT_THROW(unit_factor("stone of York", "g"), UnitError);
  EXPECT_EQ(number_with_unit("0.31").unit, "1");
  EXPECT_EQ(number_with_unit(" 12.1 g/mm").number, 12.1);
  EXPECT_EQ(number_with_unit("12.1 g/mm").unit, "g/mm");
  EXPECT_THROW(number_with_unit("g"), UnitError);
}

}  // namespace
}  // namespace diefill::process
