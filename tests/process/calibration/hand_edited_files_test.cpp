// Files of calibrations as people change them: what is no table, no row or no finer grain is named in a line.
#include <gtest/gtest.h>

#include <functional>

#include "process/calibration/calibration_file.h"
#include "process/calibration/powder_samples.h"
#include "process/calibration/starting_powder.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process::calibration {
namespace {

std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
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
  std::string region_complaint(const std::string& calibration) const {
    write("powder.toml", "[powder]\npreset = \"ASC100.29 D2\"\n\n[calibration]\n" + calibration);
    const auto scene = write("scene.toml", "[powder]\nfile = \"powder.toml\"\n");
    return complaint([&] { powder_region_of(scene); });
  }

  SceneFolder folder_;
};

TEST_F(HandEditedFiles, AStartingPowderThatIsNoTableIsRefused) {
  const auto scene = write("scene.toml", faultless_scene());
  for (const auto& [text, found] : {std::pair{"powder = 3\n", "powder.toml:1:10: powder: found 3"},
                                    {"[[powder]]\npreset = \"ASC100.29 D2\"\n", "powder.toml:1"},
                                    {"walls = 3\n", "powder.toml:1:9: walls: found 3"}})
    expect_one_line_with(complaint([&, words = std::string(text)] {
                           with_starting_powder(scene, write("powder.toml", words));
                         }),
                         {found, "expected one table"});
  expect_one_line_with(
      complaint([&] { with_starting_powder(scene, write("powder.toml", "friction = 3\n")); }),
      {"found no [powder]"});
}

TEST_F(HandEditedFiles, ACalibrationWhoseParametersAreNoTablesIsRefused) {
  expect_one_line_with(region_complaint("parameter = [1, 2]\nsamples = [[1.0, 2.0]]\n"),
                       {"powder.toml:5", "calibration.parameter: found 1,", "expected a list of tables"});
  const std::string samples = "samples = [[1.0]]\n[[calibration.parameter]]\n";
  expect_one_line_with(region_complaint(samples + "best = 1.0\n"),
                       {"powder.toml:6", "calibration.parameter.key: found nothing"});
  expect_one_line_with(region_complaint(samples + "key = \"\"\nbest = 1.0\n"),
                       {"calibration.parameter.key: found \"\"", "the path of a key alone"});
  expect_one_line_with(region_complaint(samples + "key = \"powder.friction\"\nbest = \"1\"\n"),
                       {"calibration.parameter.best: found \"1\""});
}

TEST_F(HandEditedFiles, ASampleThatIsNoRowOfNumbersIsNamedByItsLine) {
  const std::string parameter = "[[calibration.parameter]]\nkey = \"powder.friction\"\nbest = 1.0\n";
  for (const char* row : {"[1.0, 2.0]", "3.0", "[\"1\"]", "[nan]"})
    expect_one_line_with(
        region_complaint("samples = [\n  [0.9],\n  " + std::string(row) + "\n]\n" + parameter),
        {"powder.toml:7: calibration.samples: found ",
         "one number for each [[calibration.parameter]], 1 in all"});
  expect_one_line_with(region_complaint("agrees = true\n"), {"found no [calibration] with samples"});
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
    return complaint([&] { read_calibration(write("calibration.toml", calibration + size + "\"\n")); });
  };
  expect_one_line_with(refusal("2.4 mm"), {"calibration.toml:14:", "check.grain_diameter: found \"2.4 mm\"",
                                           "allowed: less than the 1.88", "measurement \"mass\""});
  EXPECT_NE(refusal("1.88 mm"), "no complaint");
  EXPECT_EQ(refusal("1.4 mm"), "no complaint");
}

}  // namespace
}  // namespace diefill::process::calibration
