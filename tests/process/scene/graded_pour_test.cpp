// pour.graded: fine grains below, larger ones of the same powder above.
#include <gtest/gtest.h>

#include "process/scene/reading/sections.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

const std::string kHeight = "fill_height = \"24 mm\"\n";

Scene with_pour(const std::string& more, const std::string& powder = "") {
  const SceneFolder folder;
  const std::string text = support::exchanged(faultless_scene(), kHeight, kHeight + more);
  return read_scene(folder.write(support::exchanged(text, "grain_diameter", powder + "grain_diameter")));
}

std::string refusal(const std::string& more, const std::string& powder = "") {
  try {
    with_pour(more, powder);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(GradedPour, PutsLargerGrainsOfTheSamePowderAboveFineOnes) {
  const Scene scene = with_pour("graded = { depth = \"6 mm\", factor = 1.5 }\n", "friction = 0.4\n");
  ASSERT_EQ(scene.other_powders.size(), 1U);
  const PowderSpec& coarse = scene.other_powders[0].powder;
  EXPECT_EQ(coarse.label, scene.powder.label + ", coarse");
  EXPECT_NEAR(coarse.grain_diameter, 1.5 * scene.powder.grain_diameter, 1e-15);
  EXPECT_EQ(coarse.friction, 0.4);
  EXPECT_EQ(coarse.work_of_adhesion, scene.powder.work_of_adhesion);
  ASSERT_EQ(scene.pour.layers.size(), 2U);
  EXPECT_EQ(scene.pour.layers[0].powder, 0U);
  EXPECT_NEAR(scene.pour.layers[0].share, 0.25, 1e-12);
  EXPECT_EQ(scene.pour.layers[1].powder, 1U);
  EXPECT_NEAR(scene.pour.layers[1].share, 0.75, 1e-12);
}

TEST(GradedPour, ScenesReadFromTheirStoredTextAreTheSame) {
  const Scene scene = with_pour("graded = { depth = \"6 mm\" }\n");
  const SceneFolder folder;
  const Scene again = read_scene(folder.write(scene.text));
  ASSERT_EQ(again.other_powders.size(), 1U);
  EXPECT_NEAR(again.other_powders[0].powder.grain_diameter, 2 * scene.powder.grain_diameter, 1e-15);
  EXPECT_EQ(again.pour.layers[0].share, scene.pour.layers[0].share);
}

TEST(GradedPour, WithoutItThereIsOnePowder) {
  EXPECT_TRUE(with_pour("").other_powders.empty());
}

TEST(GradedPour, RefusesWhatLeavesNoLayerOrOtherGrains) {
  EXPECT_NE(refusal("graded = { depth = \"24 mm\" }\n").find("depth must be less than all powder"),
            std::string::npos);
  EXPECT_NE(refusal("graded = { depth = \"6 mm\", factor = 5 }\n").find("pour.graded.factor"),
            std::string::npos);
  EXPECT_NE(refusal("graded = { factor = 2 }\n").find("depth"), std::string::npos);
  EXPECT_NE(refusal("graded = { depth = \"6 mm\", fctor = 2 }\n").find("factor"), std::string::npos);
  EXPECT_NE(refusal("graded = { depth = \"6 mm\" }\nlayers = []\n").find("pour.layers"), std::string::npos);
  EXPECT_NE(refusal("graded = { depth = \"6 mm\" }\n[[other_powder]]\nname = \"x\"\n").find("other_powder"),
            std::string::npos);
}

}  // namespace
}  // namespace diefill::process
