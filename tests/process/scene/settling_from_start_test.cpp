// A first step that takes the place of the wait until the poured powder rests.
#include <gtest/gtest.h>

#include "process/machine/actions/settle.h"
#include "process/scene/reading/sections.h"
#include "process/tooling/stages.h"
#include "tests/process/scene_files.h"
#include "tests/process/wrong_scene.h"

namespace diefill::process {
namespace {

const std::string kSettling = "[[step]]\nkind = \"settle\"\nduration = \"0.3 s\"\n";

Scene with_steps(const std::string& before, const std::string& after = "") {
  const SceneFolder folder;
  std::string text = support::exchanged(faultless_scene(), "[[step]]", before + "\n[[step]]");
  return read_scene(folder.write(support::exchanged(text, "\n[numerics]", "\n" + after + "\n[numerics]")));
}

std::string refusal(const std::string& before, const std::string& after) {
  try {
    with_steps(before, after);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(SettlingFromStart, TakesThePlaceOfTheWaitForRest) {
  const Stages stages(with_steps(kSettling + "from_start = true\n"));
  EXPECT_EQ(stages.steps[0]->duration(), 0.0);
  EXPECT_EQ(stages.steps[1]->duration(), 0.3);
}

TEST(SettlingFromStart, WithoutItThePowderRestsFirst) {
  const Stages stages(with_steps(kSettling));
  EXPECT_FALSE(stages.steps[0]->duration());
}

TEST(SettlingFromStart, IsForTheFirstStepAndHasNoCondition) {
  EXPECT_NE(refusal("", kSettling + "from_start = true\n").find("only the first step"), std::string::npos);
  EXPECT_NE(refusal(kSettling + "from_start = true\nstart = { at = \"1 s\" }\n", "").find("remove start"),
            std::string::npos);
}

}  // namespace
}  // namespace diefill::process
