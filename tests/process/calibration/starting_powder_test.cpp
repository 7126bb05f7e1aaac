// The powder of a calibration as a file, and in the scenes of its measurements.
#include "process/calibration/starting_powder.h"

#include <gtest/gtest.h>

#include "process/calibration/powder_samples.h"
#include "process/scene/powder/powder_file.h"
#include "tests/process/fitted_with.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process::calibration {
namespace {

/// The faultless scene with these keys of [powder].
std::string scene_with(const std::string& powder) {
  return support::exchanged(faultless_scene(), "preset = \"Distaloy AE\"\ngrain_diameter = \"1.88 mm\"\n",
                            powder);
}

TEST(StartingPowder, AClumpOfAFileIsFoundFromOtherFolders) {
  const support::TemporaryFolder of_powder;
  const SceneFolder of_scene, of_die;
  const auto spheres =
      of_powder.write("grain.csv", "x [mm], y [mm], z [mm], radius [mm]\n0, 0, 0, 0.6\n0.5, 0, 0, 0.4\n");
  const auto powder = of_powder.write("start.toml",
                                      "[powder]\npreset = \"Distaloy AE\"\nspheres_file = "
                                      "\"grain.csv\"\ngrain_diameter = \"1.88 mm\"\n");
  // In the scene of a measurement, in powder.toml, and in a scene that takes it from there.
  const auto scene_file = of_scene.write(faultless_scene());
  const Scene fitted = parse_scene(with_starting_powder(scene_file, powder), scene_file);
  ASSERT_NE(fitted.powder.clump, nullptr);
  const std::string text = powder_file_text(fitted, "", "", "1.0.0");
  EXPECT_NE(text.find(spheres.string()), std::string::npos) << text;
  std::ofstream(of_die.path() / "powder.toml") << text;
  EXPECT_NE(read_scene(of_die.write(scene_with("file = \"powder.toml\"\n"))).powder.clump, nullptr);
  // Fitted in the scene's own folder, with a path beside it.
  std::filesystem::copy_file(spheres, of_scene.path() / "grain.csv");
  const Scene own = read_scene(of_scene.write(
      scene_with("preset = \"Distaloy AE\"\nspheres_file = \"grain.csv\"\ngrain_diameter = \"1.88 mm\"\n")));
  std::ofstream(of_die.path() / "powder.toml") << powder_file_text(own, "", "", "1.0.0");
  EXPECT_NE(read_scene(of_die.write(scene_with("file = \"powder.toml\"\n"))).powder.clump, nullptr);
}

TEST(StartingPowder, APowderFileBesideItsClumpIsUsedFromElsewhere) {
  const SceneFolder folder;
  const auto below = folder.path() / "powders";
  std::filesystem::create_directory(below);
  std::ofstream(below / "grain.csv") << "x [mm], y [mm], z [mm], radius [mm]\n0, 0, 0, 0.6\n0.5, 0, 0, 0.4\n";
  std::ofstream(below / "powder.toml") << "[powder]\npreset = \"Distaloy AE\"\nspheres_file = \"grain.csv\"\n"
                                          "grain_diameter = \"1.88 mm\"\n";
  EXPECT_NE(read_scene(folder.write(scene_with("file = \"powders/powder.toml\"\n"))).powder.clump, nullptr);
}

TEST(PowderSamples, ThatVaryTheStiffnessAreNotWarnedOfIt) {
  const SceneFolder folder;
  std::ofstream(folder.path() / "powder.toml") << R"([powder]
preset = "ASC100.29 D2"
friction = 0.42
)" + kFittedWith + R"([calibration]
samples = [[9.0], [12.0]]

[[calibration.parameter]]
key = "powder.reduced_modulus"
unit = "MPa"
best = 10.0
)";
  const std::string keys = "file = \"powder.toml\"\ngrain_diameter = \"1.88 mm\"\n";
  const auto warnings = [&](const std::string& text) {
    const auto file = folder.write(text);
    const auto region = powder_region_of(file);
    std::vector<std::string> all;
    for (const Variant& variant : powder_variants(read_scene(file), region, region.samples, 1))
      all.push_back(fitted_with_warning(variant.scene));
    return all;
  };
  EXPECT_EQ(warnings(scene_with(keys)), (std::vector<std::string>{"", "", ""}));
  // Other walls are a difference that stays one.
  for (const std::string& warning :
       warnings(support::exchanged(scene_with(keys), "spacing = 1.6", "spacing = 2")))
    EXPECT_NE(warning.find("wall spacing 2 instead of 1.6"), std::string::npos) << warning;
}

}  // namespace
}  // namespace diefill::process::calibration
