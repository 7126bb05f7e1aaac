// Experiments of the laboratory as measurements: which can be one, and with which powder their scenes run.
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "process/calibration/measurement.h"
#include "process/input/scene_error.h"
#include "process/scene/scene_text.h"
#include "project_paths.h"
#include "tests/process/fitted_with.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::calibration {
namespace {

/// A calibrated powder with walls, before it is fitted again.
class Experiments : public testing::Test {
 protected:
  Experiments() {
    folder_.write("powder.toml", R"([powder]
preset = "ASC100.29 D2"
friction = 0.42
)" + kFittedWith + R"([walls]
sphere_radius = "0.15 mm"
friction = 0.31
)");
  }
  Measurement read(const std::string& experiment, const std::string& quantity, const std::string& unit = "",
                   const std::string& value = "0.5") const {
    const toml::table parsed =
        toml::parse("[[measurement]]\nname = \"a\"\nkind = \"experiment\"\nexperiment = \"" + experiment +
                    "\"\nscenes = \"" + DIEFILL_SOURCE_DIR + "/sample_tools/laboratory\"\nquantity = \"" +
                    quantity + "\"\nvalue = \"" + value + unit + "\"\ndeviation = \"0.1" + unit + "\"\n");
    TableReader document(parsed, folder_.path() / "calibration.toml", "");
    return read_measurements(document, {folder_.path() / "powder.toml"}).at(0);
  }
  std::string message_of(const std::string& experiment, const std::string& quantity,
                         const std::string& unit = "", const std::string& value = "0.5") const {
    try {
      read(experiment, quantity, unit, value);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no message";
  }
  /// The document of its only run.
  static toml::table scene_of(const Measurement& measurement) {
    EXPECT_EQ(measurement.runs.size(), 1U);
    return parse_scene_text(measurement.runs.front().text, measurement.runs.front().file);
  }
  void expect_varied_values() const {
    const toml::table walls =
        scene_of(read("wall_discharge", "discharged area, mu_w = 0.25, spacing 1.6 R_w", " mm^2"));
    EXPECT_EQ(walls["walls"]["friction"].value<double>(), 0.25);
    EXPECT_EQ(walls["walls"]["spacing"].value<double>(), 1.6);
    EXPECT_EQ(walls["powder"]["friction"].value<double>(), 0.42);
    const toml::table stiff = scene_of(read("youngs_modulus", "fraction, E = 1000000000 Pa"));
    EXPECT_EQ(stiff["powder"]["reduced_modulus"].value<std::string>(), "1000000000 Pa");
  }

  support::TemporaryFolder folder_;
};

TEST_F(Experiments, WithoutScenesAreRefused) {
  for (const char* experiment : {"closed_forms", "hopper_design", "wire_sawing"}) {
    const std::string said = message_of(experiment, "V04");
    EXPECT_NE(said.find("found \"" + std::string(experiment) + "\""), std::string::npos) << said;
    EXPECT_NE(said.find("this experiment runs no scenes, which take a powder"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  EXPECT_NE(message_of("clump_collision", "B01").find("powders of its own"), std::string::npos);
}

TEST_F(Experiments, WithImpossibleValuesAreRefused) {
  const auto expect = [&](const std::string& quantity, const std::string& value, const std::string& unit,
                          const std::string& part) {
    const std::string experiment = quantity == "theta_O" ? "angle_of_repose" : "powder_sheet";
    const std::string said = message_of(experiment, quantity, unit, value);
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  };
  expect("hall_flow", "-30", " s", "found value -30 s, allowed: 0 s or more");
  expect("apparent_density", "300", " g/cm^3", "found value 300 g/cm^3, allowed: 0 to 7.87 g/cm^3");
  expect("hausner", "0.5", "", "found value 0.5, allowed: 1 or more");
  expect("theta_O", "390", " deg", "found value 390 deg, allowed: 0 to 90 deg");
  expect("apparent_fraction", "38", "", "found value 38, allowed: 0 to 1");
  expect("hall_flow", "30", " s", "no message");
  expect("apparent_density", "3", " g/cm^3", "no message");
  expect("hausner", "1.2", "", "no message");
}

TEST_F(Experiments, TakeTheStartingPowderWithItsWalls) {
  const toml::table scene = scene_of(read("mean_fractions", "settled"));
  EXPECT_EQ(scene["powder"]["friction"].value<double>(), 0.42);
  EXPECT_EQ(scene["walls"]["friction"].value<double>(), 0.31);
  EXPECT_FALSE(scene["powder"].as_table()->contains("file"));
  EXPECT_FALSE(scene["powder"].as_table()->contains("fitted_with"));
}

TEST_F(Experiments, KeepTheFrictionAndModulusThatTheyVary) {
  expect_varied_values();
}

TEST_F(Experiments, KeepWhatTheyVaryWhereTheStartingPowderIsAScene) {
  for (const char* tool : {"die.stl", "shoe.stl"}) folder_.write(tool, "");
  support::SceneTables scene;
  scene.powder = "preset = \"ASC100.29 D2\"\nfriction = 0.42\nreduced_modulus = \"5 MPa\"\n";
  scene.walls = "sphere_radius = \"0.15 mm\"\nspacing = 1.6\nfriction = 0.31\n";
  folder_.write("powder.toml", support::scene_text(scene));
  expect_varied_values();
  EXPECT_EQ(scene_of(read("mean_fractions", "settled"))["walls"]["friction"].value<double>(), 0.31);
}

}  // namespace
}  // namespace diefill::process::calibration
