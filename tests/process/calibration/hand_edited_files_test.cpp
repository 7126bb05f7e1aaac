// Files of calibrations as people change them: what is no table, no row or no finer grain is named in a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "process/calibration/calibration_file.h"
#include "process/calibration/powder_samples.h"
#include "process/calibration/starting_powder.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process::calibration {
namespace {

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no message";
}

void expect_one_line_with(const std::string& message, const std::vector<std::string>& parts) {
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "missing: " << part << "\nin: " << message;
}

/// A folder with a scene and other files beside it.
class HandEditedFiles : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
    return folder_.path() / name;
  }
  std::string region_message(const std::string& calibration) const {
    write("powder.toml", "[powder]\npreset = \"ASC100.29 D2\"\n\n[calibration]\n" + calibration);
    const auto scene = write("scene.toml", "[powder]\nfile = \"powder.toml\"\n");
    return message_of([&] { powder_region_of(scene); });
  }

  SceneFolder folder_;
};

TEST_F(HandEditedFiles, AStartingPowderThatIsNoTableIsRefused) {
  const auto scene = write("scene.toml", faultless_scene());
  for (const auto& [text, found] : {std::pair{"powder = 3\n", "powder.toml:1:10: powder: found 3"},
                                    {"[[powder]]\npreset = \"ASC100.29 D2\"\n", "powder.toml:1"},
                                    {"walls = 3\n", "powder.toml:1:9: walls: found 3"}})
    expect_one_line_with(message_of([&, words = std::string(text)] {
                           with_starting_powder(scene, write("powder.toml", words));
                         }),
                         {found, "expected one table"});
  expect_one_line_with(
      message_of([&] { with_starting_powder(scene, write("powder.toml", "friction = 3\n")); }),
      {"found no [powder]"});
}

TEST_F(HandEditedFiles, ACalibrationWhoseParametersAreNoTablesIsRefused) {
  expect_one_line_with(region_message("parameter = [1, 2]\nsamples = [[1.0, 2.0]]\n"),
                       {"powder.toml:5", "calibration.parameter: found 1,", "expected a list of tables"});
  const std::string samples = "samples = [[1.0]]\n[[calibration.parameter]]\n";
  expect_one_line_with(region_message(samples + "best = 1.0\n"),
                       {"powder.toml:6", "calibration.parameter.key: found nothing"});
  expect_one_line_with(region_message(samples + "key = \"\"\nbest = 1.0\n"),
                       {"calibration.parameter.key: found \"\"", "the path of a key alone"});
  expect_one_line_with(region_message(samples + "key = \"powder.friction\"\nbest = \"1\"\n"),
                       {"calibration.parameter.best: found \"1\""});
}

TEST_F(HandEditedFiles, ASampleThatIsNoRowOfNumbersIsNamedByItsLine) {
  const std::string parameter = "[[calibration.parameter]]\nkey = \"powder.friction\"\nbest = 1.0\n";
  for (const char* row : {"[1.0, 2.0]", "3.0", "[\"1\"]", "[nan]"})
    expect_one_line_with(region_message("samples = [\n  [0.9],\n  " + std::string(row) + "\n]\n" + parameter),
                         {"powder.toml:7: calibration.samples: found ",
                          "one number for each [[calibration.parameter]], 1 in all"});
  expect_one_line_with(region_message("agrees = true\n"), {"found no [calibration] with samples"});
}

TEST_F(HandEditedFiles, ACheckWithGrainsThatAreNotFinerIsRefused) {
  write("scene.toml", faultless_scene());
  const std::string calibration = R"([[parameter]]
key = "powder.friction"
from = 0.25
to = 1.5

[[measurement]]
name = "mass"
scene = "scene.toml"
figure = "filled_mass_kg"
value = "20 g"
deviation = "1 g"

[check]
grain_diameter = ")";
  const auto refusal = [&](const std::string& size) {
    return message_of([&] { read_calibration(write("calibration.toml", calibration + size + "\"\n")); });
  };
  expect_one_line_with(refusal("2.4 mm"), {"calibration.toml:14:", "check.grain_diameter: found \"2.4 mm\"",
                                           "allowed: less than the 1.88", "measurement \"mass\""});
  EXPECT_NE(refusal("1.88 mm"), "no message");
  EXPECT_EQ(refusal("1.4 mm"), "no message");
}

/// A calibration of the faultless scene; `old` is exchanged for `text`.
class ChangedCalibration : public HandEditedFiles {
 protected:
  ChangedCalibration() { write("scene.toml", faultless_scene()); }
  std::string refusal(const std::string& old, const std::string& text) const {
    const std::string calibration = R"([[parameter]]
key = "powder.friction"
from = 0.25
to = 1.5

[[parameter]]
key = "powder.work_of_adhesion"
from = "0.001 J/m^2"
to = "0.1 J/m^2"
scale = "logarithmic"

[[measurement]]
name = "mass"
scene = "scene.toml"
figure = "filled_mass_kg"
value = "20 g"
deviation = "1 g"
)";
    return message_of(
        [&] { read_calibration(write("calibration.toml", support::exchanged(calibration, old, text))); });
  }
};

TEST_F(ChangedCalibration, AFaultOfASceneHasItsLineThere) {
  const std::string scene = faultless_scene();
  const std::string spoilt = scene + "\n[pours]\nheight = 3\n";
  write("scene.toml", spoilt);
  const auto line = std::count(spoilt.begin(), spoilt.end(), '\n') - 1;
  expect_one_line_with(refusal("1.5", "1.4"),
                       {"scene.toml:" + std::to_string(line) + ':', "under an unknown key"});
}

TEST_F(ChangedCalibration, AFaultOfTheStartingPowderHasNoLineOfTheScene) {
  write("powder.toml", "[powder]\npreset = \"ASC100.29 D2\"\nfriction = -1.0\n");
  const std::string said = refusal("[[parameter]]\nkey = \"powder.friction\"",
                                   "powder = \"powder.toml\"\n[[parameter]]\nkey = \"powder.friction\"");
  expect_one_line_with(said,
                       {"scene.toml: powder.friction: found -1", "the powder and walls of", "powder.toml)"});
}

TEST_F(ChangedCalibration, AnEndThatNoSceneTakesIsNamedByItsOwnLine) {
  expect_one_line_with(
      refusal("from = \"0.001 J/m^2\"\nto = \"0.1 J/m^2\"", "from = 0.001\nto = 0.1"),
      {"calibration.toml:8:8: parameter.from: powder.work_of_adhesion: found 0.001, expected"});
  expect_one_line_with(
      refusal("\"0.1 J/m^2\"", "\"1e300 J/m^2\""),
      {"calibration.toml:9:6: parameter.to: powder.work_of_adhesion: found \"1e+300 J/m^2\", allowed"});
}

TEST_F(ChangedCalibration, AFileThatIsNotThereIsNamedByItsKey) {
  expect_one_line_with(
      refusal("\"scene.toml\"", "\"slot.toml\""),
      {"calibration.toml:14:9: measurement.scene: found \"slot.toml\", allowed: the path of a file",
       "there is no /"});
  const std::string value = "value = \"20 g\"\ndeviation = \"1 g\"";
  expect_one_line_with(refusal(value, "file = \"nope.csv\""),
                       {"calibration.toml:16:8: measurement.file: found \"nope.csv\", allowed"});
  expect_one_line_with(refusal(value, "file = \"\""),
                       {"calibration.toml:16:8: measurement.file: found \"\", allowed"});
  expect_one_line_with(refusal(value, "file = \"parts\""),
                       {"measurement.file: found \"parts\", which is a folder"});
  expect_one_line_with(refusal("[[parameter]]\nkey = \"powder.friction\"",
                               "powder = \"\"\n[[parameter]]\nkey = \"powder.friction\""),
                       {"calibration.toml:1:10: powder: found \"\", allowed: the path of a file"});
}

TEST_F(ChangedCalibration, AKeyToRunOverThatTheSceneLacksIsNamedByItsLine) {
  write("masses.csv", "velocity [m/s], mass [g], deviation [g]\n0.1, 20, 1\n0.2, 18, 1\n");
  const std::string value = "value = \"20 g\"\ndeviation = \"1 g\"";
  expect_one_line_with(refusal(value, "file = \"masses.csv\"\nover = \"step.1.velocty\""),
                       {"calibration.toml:17:8: measurement.over: step", "velocty: found \"0.1 m/s\"",
                        "did you mean \"velocity\"?"});
  expect_one_line_with(
      refusal(value, "file = \"masses.csv\""),
      {"calibration.toml:16:8: measurement.file: found \"masses.csv\"", "over = \"step.1.velocity\""});
}

TEST_F(ChangedCalibration, AKeyThatIsAParameterIsNeitherSetNorRunOver) {
  write("masses.csv", "friction [1], mass [g], deviation [g]\n0.1, 20, 1\n0.2, 18, 1\n");
  const std::string value = "value = \"20 g\"\ndeviation = \"1 g\"",
                    parameter = "powder.friction is a [[parameter]] of this calibration";
  expect_one_line_with(refusal(value, "file = \"masses.csv\"\nover = \"powder.friction\""),
                       {"calibration.toml:17:8: measurement.over: " + parameter});
  for (const char* set : {"powder.friction = 0.3", "powder = {friction = 0.3}"})
    expect_one_line_with(refusal(value, value + "\nset = '" + set + "'"),
                         {"calibration.toml:18:7: measurement.set: " + parameter});
  EXPECT_EQ(refusal(value, value + "\nset = 'walls.friction = 0.3'"), "no message");
}

TEST_F(ChangedCalibration, AKeyThatNoExperimentVariesIsNotRunOver) {
  const std::string value = "value = \"20 g\"\ndeviation = \"1 g\"";
  for (const std::string key : {"title", "seed", "numerics.time_step_fraction"})
    expect_one_line_with(
        refusal(value, value + "\nover = \"" + key + '"'),
        {"calibration.toml:18:8: measurement.over: found \"" + key + "\", allowed: a key that"});
}

TEST_F(ChangedCalibration, AFigureOfTheComputationIsNoMeasurement) {
  for (const std::string figure :
       {"wall_seconds", "steps", "finished", "shoe_speed_m_s", "cavity_2_solid_fraction_grains"})
    expect_one_line_with(refusal("filled_mass_kg", figure),
                         {"measurement.figure: found \"" + figure + "\", this figure is of the computation"});
}

TEST_F(ChangedCalibration, AMissingOrWronglyEncodedFileIsCalledACalibration) {
  expect_one_line_with(message_of([&] { read_calibration(folder_.path() / "none.toml"); }),
                       {"found no such calibration file", "my_powder.toml"});
  const auto wide = write("wide.toml", std::string("\xFF\xFE[\0", 4));
  expect_one_line_with(message_of([&] { read_calibration(wide); }),
                       {"found UTF-16 text", "save the calibration as UTF-8 text"});
}

TEST_F(ChangedCalibration, GrainsOfTheCheckAreComparedBeforeItsSceneIsRead) {
  // Coarser than a scene may have them at all.
  expect_one_line_with(
      refusal("deviation = \"1 g\"\n", "deviation = \"1 g\"\n[check]\ngrain_diameter = \"5 m\"\n"),
      {"calibration.toml:19:18: check.grain_diameter: found \"5 m\", allowed: less than the 1.8816 mm"});
}

TEST_F(ChangedCalibration, AValueWithoutAUnitIsShownAListInSingleQuotes) {
  expect_one_line_with(refusal("\"20 g\"", "20"), {"measurement.value: found 20, expected", "[\"12.1 g\"]"});
}

}  // namespace
}  // namespace diefill::process::calibration
