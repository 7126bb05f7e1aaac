// Figures of cavities that a die does not have are noticed before anything runs.
#include "process/calibration/check_cavities.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::calibration {
namespace {

/// What is said of a calibration that measures this figure of a scene of sample_tools/small_dies.
std::string complaint(const std::string& scene, const std::string& figure) {
  const support::TemporaryFolder folder;
  const std::string path = std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/small_dies/" + scene;
  const auto file =
      folder.write("calibration.toml",
                   "[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.1\nto = 1.0\n"
                   "[[measurement]]\nname = \"filled die\"\nscene = \"" +
                       path + "\"\nfigure = \"" + figure + "\"\nvalue = \"0.9\"\ndeviation = \"0.1\"\n");
  try {
    check_cavities(read_calibration(file));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(CavitiesOfMeasurements, ThatTheDieHasPass) {
  for (const char* figure : {"fill_ratio", "cavity_2_fill_ratio"})
    EXPECT_EQ(complaint("pair.toml", figure), "no complaint") << figure;
}

TEST(CavitiesOfMeasurements, ThatTheDieDoesNotHaveAreRefusedWithThoseThatItHas) {
  for (const std::string number : {"3", "99", "99999999999999999999999"}) {
    const std::string said = complaint("pair.toml", "cavity_" + number + "_fill_ratio");
    EXPECT_NE(said.find("calibration.toml:8:"), std::string::npos) << said;
    EXPECT_NE(said.find("found \"cavity_" + number +
                        "_fill_ratio\", but the die has 2 cavities, allowed: \"fill_ratio\" or "
                        "\"cavity_2_fill_ratio\""),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  const std::string said = complaint("square.toml", "cavity_2_fill_ratio");
  EXPECT_NE(said.find("but the die has one cavity, allowed: \"fill_ratio\""), std::string::npos) << said;
}

}  // namespace
}  // namespace diefill::process::calibration
