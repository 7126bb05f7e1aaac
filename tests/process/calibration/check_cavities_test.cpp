// Figures of cavities that a die does not have are noticed before anything runs.
#include "process/calibration/check_cavities.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::calibration {
namespace {

/// What is said of a calibration with this measurement of a scene of sample_tools/small_dies; map.csv lies
/// beside it.
std::string message_of(const std::string& scene, const std::string& lines, const std::string& map = "") {
  const support::TemporaryFolder folder;
  const std::string path = std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/small_dies/" + scene;
  folder.write("map.csv", map);
  const auto file = folder.write("calibration.toml",
                                 "[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.1\nto = 1.0\n"
                                 "[[measurement]]\nname = \"filled die\"\nscene = \"" +
                                     path + "\"\n" + lines);
  try {
    check_cavities(read_calibration(file));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no message";
}

std::string message_of_figure(const std::string& scene, const std::string& figure) {
  return message_of(scene, "figure = \"" + figure + "\"\nvalue = \"0.9\"\ndeviation = \"0.1\"\n");
}

/// Of a profile of levels at two places.
std::string message_of_profile(const std::string& scene, const std::string& profile,
                               const std::string& places) {
  return message_of(scene, "kind = \"profile\"\nprofile = \"" + profile + "\"\nat = [" + places +
                               "]\nvalues = [\"5 mm\", \"6 mm\"]\ndeviations = \"1 mm\"\n");
}

std::string message_of_map(const std::string& scene, const std::string& header) {
  return message_of(scene, "kind = \"map\"\nmap = \"solid fraction\"\nfile = \"map.csv\"\n",
                    header + ", solid fraction [1], deviation [1]\n1, 2, 0.3, 0.01\n");
}

TEST(CavitiesOfMeasurements, ThatTheDieHasPass) {
  for (const char* figure : {"fill_ratio", "cavity_2_fill_ratio"})
    EXPECT_EQ(message_of_figure("pair.toml", figure), "no message") << figure;
}

TEST(CavitiesOfMeasurements, ThatTheDieDoesNotHaveAreRefusedWithThoseThatItHas) {
  for (const std::string number : {"3", "99", "99999999999999999999999"}) {
    const std::string said = message_of_figure("pair.toml", "cavity_" + number + "_fill_ratio");
    EXPECT_NE(said.find("calibration.toml:8:"), std::string::npos) << said;
    EXPECT_NE(said.find("found \"cavity_" + number +
                        "_fill_ratio\", but the die has 2 cavities, allowed: \"fill_ratio\" or "
                        "\"cavity_2_fill_ratio\""),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  const std::string said = message_of_figure("square.toml", "cavity_2_fill_ratio");
  EXPECT_NE(said.find("but the die has one cavity, allowed: \"fill_ratio\""), std::string::npos) << said;
}

TEST(FiguresOfMeasurements, OfAnotherShapeOfCavityAreRefused) {
  EXPECT_EQ(message_of_figure("ring_6mm.toml", "solid_fraction_harmonic_1"), "no message");
  EXPECT_EQ(message_of_figure("square.toml", "solid_fraction_along_travel_1"), "no message");
  const std::string of_square = message_of_figure("square.toml", "solid_fraction_harmonic_1");
  EXPECT_NE(of_square.find("calibration.toml:8:"), std::string::npos) << of_square;
  EXPECT_NE(of_square.find("only rings have it, and the cavity is none"), std::string::npos) << of_square;
  const std::string of_ring = message_of_figure("ring_6mm.toml", "solid_fraction_along_travel_1");
  EXPECT_NE(of_ring.find("only cavities that are no ring have it, and the cavity is a ring"),
            std::string::npos)
      << of_ring;
}

TEST(FiguresOfMeasurements, OfCavitiesAreRefusedWhereTheToolsHaveNone) {
  const std::string said = message_of_figure("../calibration/slit.toml", "fill_ratio");
  EXPECT_NE(said.find("the tools have no cavity"), std::string::npos) << said;
}

TEST(FieldsOfMeasurements, ThatResultsOfTheDieHavePass) {
  EXPECT_EQ(message_of_profile("ring_6mm.toml", "fill level", "\"10 deg\", \"200 deg\""), "no message");
  EXPECT_EQ(message_of_profile("square.toml", "fill level", "\"1 mm\", \"3 mm\""), "no message");
  EXPECT_EQ(message_of_map("ring_6mm.toml", "azimuth [deg], height [mm]"), "no message");
  EXPECT_EQ(message_of_map("square.toml", "x [mm], y [mm]"), "no message");
}

TEST(FieldsOfMeasurements, OfAnotherShapeOfCavityAreRefusedBeforeAnythingRuns) {
  const auto expect = [](const std::string& said, const std::string& part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  };
  const std::string over_azimuth = message_of_profile("square.toml", "fill level", "\"10 deg\", \"200 deg\"");
  expect(over_azimuth, "calibration.toml:10:");
  expect(over_azimuth,
         "only rings have a fill level over azimuth, and the cavity is none; allowed: places over distance "
         "along the shoe's travel");
  expect(message_of_profile("ring_6mm.toml", "fill level", "\"1 mm\", \"3 mm\""),
         "only cavities that are no ring have a fill level over distance along the shoe's travel, x and y, "
         "and the cavity is a ring; allowed: places over azimuth");
  const std::string map = message_of_map("square.toml", "azimuth [deg], height [mm]");
  expect(map, "map.csv:1:1:");
  expect(map, "only rings have a solid fraction over azimuth and height");
  expect(message_of_map("ring_6mm.toml", "x [mm], y [mm]"), "allowed: places over azimuth and height");
  expect(message_of_profile("square.toml", "fill level, cavity 2", "\"1 mm\", \"3 mm\""),
         "found \"fill level, cavity 2\", but the die has one cavity");
}

}  // namespace
}  // namespace diefill::process::calibration
