// Measurements that no run of a scene can have are refused when the calibration file is read.
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <cmath>
#include <fstream>

#include "process/calibration/measurement.h"
#include "process/calibration/possible_figures.h"
#include "process/input/scene_error.h"
#include "tests/process/results_sample.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process::calibration {
namespace {

class Measurements : public testing::Test {
 protected:
  Measurements() {
    folder_.write(faultless_scene() +
                  "[[measure.zone]]\nname = \"flange\"\nheights = [\"-5 mm\", \"0 mm\"]\n");
  }
  /// What is said of a [[measurement]] with these lines.
  std::string message_of(const std::string& lines, const std::string& csv = "") const {
    std::ofstream(folder_.path() / "m.csv") << csv;
    const toml::table parsed = toml::parse("[[measurement]]\nname = \"a\"\nscene = \"scene.toml\"\n" + lines);
    try {
      TableReader document(parsed, folder_.path() / "calibration.toml", "");
      read_measurements(document, {});
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no message";
  }
  /// What a measurement with these lines has of a result.
  std::vector<double> simulated(const std::string& lines, const results::FillResult& result) const {
    const toml::table parsed = toml::parse("[[measurement]]\nname = \"a\"\nscene = \"scene.toml\"\n" + lines);
    TableReader document(parsed, folder_.path() / "calibration.toml", "");
    return read_measurements(document, {}).at(0).simulated({{"", &result}});
  }
  void expect(const std::string& lines, const std::string& part, const std::string& csv = "") const {
    const std::string said = message_of(lines, csv);
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }

  SceneFolder folder_;
};

TEST_F(Measurements, OfFiguresThatTheSceneHasAreRead) {
  const std::string one = "value = \"0.3\"\ndeviation = \"0.01\"\n";
  for (const char* figure :
       {"mass_share_in_flange", "solid_fraction_in_flange", "cavity_2_solid_fraction_mean", "solid_fraction"})
    EXPECT_EQ(message_of("figure = \"" + std::string(figure) + "\"\n" + one), "no message") << figure;
  EXPECT_EQ(message_of("figure = \"filled_mass_in_flange_kg\"\nvalue = \"3 g\"\ndeviation = \"1 g\"\n"),
            "no message");
}

// Zones are of all cavities together: no run would have a value.
TEST_F(Measurements, OfZonesOfFurtherCavitiesAreRefused) {
  expect("figure = \"cavity_3_mass_share_in_flange\"\nvalue = \"0.3\"\ndeviation = \"0.01\"\n",
         "of further cavities there are no figures of zones; allowed: \"mass_share_in_flange\", of all");
}

TEST_F(Measurements, OfSizesAndPowdersThatTheSceneDoesNotHaveAreRefused) {
  const std::string one = "value = \"0.3\"\ndeviation = \"0.01\"\n";
  expect("figure = \"mixing_index_height\"\n" + one, "all grains have one size");
  for (const char* figure : {"powder_mixing_index_height", "first_powder_mass_share_filled"})
    expect("figure = \"" + std::string(figure) + "\"\n" + one, "the scene has one powder");
}

TEST_F(Measurements, OfFlowsThatTheSceneDoesNotRecordAreRefused) {
  const std::string mass = "value = \"3 g\"\ndeviation = \"0.1 g\"\n";
  expect("figure = \"real_mass_through_slit\"\n" + mass,
         "the scene has no [[probe]] with quantity = \"flow\"; add one with name = \"slit\"");
  folder_.write(faultless_scene() +
                "[[probe]]\nname = \"tray\"\nquantity = \"flow\"\norigin = [\"0 mm\", \"0 mm\", \"-2 mm\"]\n"
                "normal = \"-z\"\ninterval = \"1 ms\"\n");
  expect("figure = \"mass_through_slit\"\n" + mass, "\"mass_through_tray\"");
  EXPECT_EQ(message_of("figure = \"mass_through_tray\"\n" + mass), "no message");
  expect("figure = \"real_mass_through_tray\"\n" + mass, "set powder.apparent_density");
}

TEST_F(Measurements, OfPlacesThatTheSceneCannotHaveAreNamedWithTheirLine) {
  const std::string curve = "figure = \"filled_mass_kg\"\nover = \"powder.friction\"\nfile = \"m.csv\"\n";
  expect(curve, "m.csv:3: ", "friction [1], mass [g], deviation [g]\n0.1, 3, 0.1\n500, 3, 0.1\n");
  expect(curve, "m.csv:2: ", "friction [1], mass [g], deviation [g]\n-1, 3, 0.1\n0.5, 3, 0.1\n");
  expect("figure = \"filled_mass_kg\"\nover = \"powder.frction\"\nfile = \"m.csv\"\n",
         "calibration.toml:5:", "friction [1], mass [g], deviation [g]\n0.1, 3, 0.1\n0.5, 3, 0.1\n");
}

TEST_F(Measurements, OfOneRunAndOneQuantityCountOnce) {
  const std::string one = "figure = \"filled_mass_kg\"\nvalue = \"3 g\"\ndeviation = \"0.1 g\"\n",
                    other = one + "\n[[measurement]]\nname = \"b\"\nscene = \"scene.toml\"\n";
  expect(other + one, "measurement \"a\" is of the same run and the same quantity, which would count twice");
  EXPECT_EQ(message_of(other + one + "use = \"check\"\n"), "no message");
  EXPECT_EQ(message_of(other + one + "set = [\"seed = 3\"]\n"), "no message");
  EXPECT_EQ(message_of(other + "figure = \"fill_ratio\"\nvalue = \"0.9\"\ndeviation = \"0.1\"\n"),
            "no message");
}

TEST_F(Measurements, OfFurtherCavitiesAreReadByTheNameThatResultsGiveThem) {
  results::FillResult result;
  result.figures = {{"cavity_2_solid_fraction", 0.31}, {"cavity_2_volume_m3", 2e-6}};
  EXPECT_EQ(
      simulated("figure = \"cavity_2_solid_fraction_mean\"\nvalue = \"0.3\"\ndeviation = \"0.01\"\n", result),
      std::vector{0.31});
  EXPECT_NEAR(simulated("figure = \"cavity_2_cavity_volume_m3\"\nvalue = \"1 cm^3\"\ndeviation = \"1 "
                        "cm^3\"\n",
                        result)
                  .at(0),
              2, 1e-12);
}

TEST_F(Measurements, OfAnglesRoundACircleCountTheShorterWay) {
  results::FillResult result;
  result.figures["solid_fraction_harmonic_1_azimuth_deg"] = 359;
  result.figures["solid_fraction_harmonic_2_azimuth_deg"] = 178;
  const std::string lines = "value = \"2 deg\"\ndeviation = \"1 deg\"\n";
  EXPECT_NEAR(simulated("figure = \"solid_fraction_harmonic_1_azimuth_deg\"\n" + lines, result).at(0), -1,
              1e-9);
  EXPECT_NEAR(simulated("figure = \"solid_fraction_harmonic_2_azimuth_deg\"\n" + lines, result).at(0), -2,
              1e-9);
}

TEST_F(Measurements, OfOtherFiguresAreRefusedWithThoseThatThereAre) {
  const std::string one = "value = \"0.3\"\ndeviation = \"0.01\"\n";
  expect("figure = \"mass_share_in_flnge\"\n" + one,
         "found \"mass_share_in_flnge\", allowed: \"mass_share_in_flange\"; did you mean "
         "\"mass_share_in_flange\"?");
  expect("figure = \"slope_of_heap_deg\"\n" + one, "the scene has no [[measure.heap]]");
  expect("figure = \"cavity_1_fill_ratio\"\n" + one, "further cavities have the numbers 2, 3 and so on");
  expect("figure = \"cavity_2_mass_share_in_hub\"\n" + one, "allowed: \"mass_share_in_flange\"");
}

TEST_F(Measurements, WithImpossibleValuesAreRefused) {
  expect("figure = \"expected_mass_kg\"\nvalue = \"-12 g\"\ndeviation = \"1 g\"\n",
         "value: point 1: found value -12 g, allowed: 0 g or more");
  expect("figure = \"mass_share_in_flange\"\nvalue = \"35\"\ndeviation = \"1\"\n",
         "found value 35, allowed: 0 to 1");
  EXPECT_EQ(message_of("figure = \"mass_share_in_flange\"\nvalue = \"35 %\"\ndeviation = \"1 %\"\n"),
            "no message");
  expect(
      "kind = \"profile\"\nprofile = \"solid fraction\"\nat = [\"1 mm\"]\nvalues = [\"3\"]\ndeviations = "
      "\"0.1\"\n",
      "found values 3, allowed: 0 to 1");
}

TEST(PossibleFigures, OfAZoneThatIsCalledAsAnotherFigureAreThoseOfItsDimension) {
  for (const char* figure : {"filled_mass_in_shared_hub", "filled_mass_in_full_fill_ratio_kg"}) {
    EXPECT_EQ(possible_values_of_figure(figure, "g").unit, "g") << figure;
    EXPECT_TRUE(std::isinf(possible_values_of_figure(figure, "g").most)) << figure;
  }
  EXPECT_EQ(possible_values_of_figure("mass_share_in_shared_hub", "%").most, 1);
  EXPECT_EQ(possible_values_of_figure("solid_fraction_in_slope_of_die", "1").most, 1);
}

TEST_F(Measurements, OfMoreValuesThanAFitCanTakeAreRefused) {
  std::string csv = "x [mm], y [mm], solid fraction [1], deviation [1]\n";
  for (int k = 0; k < 1001; ++k)
    csv += std::to_string(k % 40) + ", " + std::to_string(k / 40) + ", 0.3, 0.01\n";
  const std::string map = "kind = \"map\"\nfile = \"m.csv\"\nmap = \"solid fraction\"\n";
  expect(map,
         "m.csv: found 1001 values of \"a\", allowed: at most 1000 with use = \"fit\"; average on a coarser "
         "grid, no finer than the averaging width",
         csv);
  // One to fit has to be there; a map for checking may have any number of values.
  EXPECT_EQ(message_of("figure = \"solid_fraction\"\nvalue = \"0.3\"\ndeviation = \"0.01\"\n[[measurement]]\n"
                       "name = \"b\"\nscene = \"scene.toml\"\nuse = \"check\"\n" +
                           map,
                       csv),
            "no message");
}

TEST_F(Measurements, OfALevelOverSectorsWithoutPowderAreZeroThere) {
  const toml::table parsed = toml::parse(
      "[[measurement]]\nname = \"ring\"\nscene = \"scene.toml\"\nkind = \"profile\"\nprofile = \"fill "
      "level\"\nat = [\"45 deg\", \"90 deg\", \"135 deg\", \"225 deg\"]\nvalues = [\"1 mm\", \"1 mm\", \"1 "
      "mm\", \"1 mm\"]\ndeviations = \"1 mm\"\n");
  TableReader document(parsed, folder_.path() / "calibration.toml", "");
  const auto measurements = read_measurements(document, {});
  const results::FillResult result = results::sample_result();  // without a level at 135 degrees
  const std::vector<double> levels = measurements.at(0).simulated({{"", &result}});
  EXPECT_EQ(levels, (std::vector<double>{14.5, 7.25, 0, 13.25}));
}

TEST_F(Measurements, OfProfilesAndMapsThatNoResultHasAreRefused) {
  const std::string lists =
      "at = [\"1 mm\", \"2 mm\"]\nvalues = [\"3 mm\", \"4 mm\"]\ndeviations = \"1 mm\"\n";
  const std::string profile = "kind = \"profile\"\nprofile = ",
                    map = "kind = \"map\"\nfile = \"m.csv\"\nmap = ";
  EXPECT_EQ(message_of(profile + "\"fill level\"\n" + lists), "no message");
  expect(profile + "\"fill levl\"\n" + lists, "profile: found \"fill levl\", allowed: \"fill level\"");
  expect(profile + "\"fill levl\"\n" + lists, "did you mean \"fill level\"?");
  expect(profile + "\"fill level over azimuth\"\n" + lists, "allowed: a unit such as \"deg\"");
  expect(
      profile + "\"fill level\"\nat = [\"1\", \"2\"]\nvalues = [\"3 mm\", \"4 mm\"]\ndeviations = \"1 mm\"\n",
      "found places in \"1\", allowed: a unit such as \"deg\" (azimuth) or \"mm\" (distance along the");
  const std::string csv = "x [mm], y [mm], solid fraction [1], deviation [1]\n1, 2, 0.3, 0.01\n";
  EXPECT_EQ(message_of(map + "\"solid fraction\"\n", csv), "no message");
  // A name of the plant's own, and deviations in the last column.
  EXPECT_EQ(message_of(map + "\"solid fraction\"\n",
                       "azimuth [deg], height [mm], CT [1], s [1]\n1, 2, 0.3, 0.01\n"),
            "no message");
  expect(map + "\"nothing\"\n", "map: found \"nothing\", allowed: \"solid fraction\", \"fill level\"", csv);
  expect(map + "\"fill level\"\n", "column of values: found \"solid fraction\", allowed: \"fill level\"",
         csv);
  expect(map + "\"solid fraction\"\n", "found no column of standard deviations",
         "x [mm], y [mm], solid fraction [1]\n1, 2, 0.3\n");
  expect(map + "\"solid fraction\"\n", "m.csv:1:1: found places in \"s\"",
         "x [s], y [mm], solid fraction [1], deviation [1]\n1, 2, 0.3, 0.01\n");
}

}  // namespace
}  // namespace diefill::process::calibration
