// Powders of a region in a scene: with a value of its own of a fitted key it would compare two powders.
#include "process/calibration/powder_samples.h"

#include <gtest/gtest.h>

#include "process/scene/scene.h"
#include "tests/process/fitted_with.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process::calibration {
namespace {

class PowderOfItsOwn : public testing::Test {
 protected:
  PowderOfItsOwn() {
    std::ofstream(folder_.path() / "powder.toml") << R"([powder]
preset = "ASC100.29 D2"
friction = 0.42
)" + kFittedWith + R"([calibration]
samples = [[0.4], [0.5]]

[[calibration.parameter]]
key = "powder.friction"
unit = "1"
best = 0.42
)";
  }
  /// What is said of a scene with these lines in [powder], run with `set`.
  std::string message_of(const std::string& powder, const std::string& set = "") const {
    const std::string text = support::exchanged(faultless_scene(), "preset = \"Distaloy AE\"\n",
                                                "file = \"powder.toml\"\n" + powder);
    const auto file = folder_.write(text);
    SceneChanges changes;
    changes.set = set;
    try {
      refuse_own_values(changed_scene(text, file, changes), powder_region_of(file));
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no message";
  }

  SceneFolder folder_;
};

TEST_F(PowderOfItsOwn, IsRefusedWithTheLineOfTheKey) {
  const std::string said = message_of("friction = 0.9\n");
  EXPECT_NE(said.find("scene.toml:6:12: powder.friction: found 0.9, but --powder-samples draws it from "
                      "powder.toml; remove the key from the scene, or run without --powder-samples"),
            std::string::npos)
      << said;
}

TEST_F(PowderOfItsOwn, IsRefusedWhereAChangeGivesIt) {
  const std::string said = message_of("", "powder.friction = 0.9");
  EXPECT_NE(said.find("it draws powder.friction from powder.toml, but --set"), std::string::npos) << said;
}

TEST_F(PowderOfItsOwn, IsNoneWhereTheSceneSetsOtherKeys) {
  EXPECT_EQ(message_of("reduced_modulus = \"5 MPa\"\n", "walls.friction = 0.2"), "no message");
}

}  // namespace
}  // namespace diefill::process::calibration
