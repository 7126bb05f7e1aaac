// Changes that a command line gives, and paths of keys: what would change nothing is refused.
#include "process/scene/given_changes.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "process/scene/key_path.h"

namespace diefill::process {
namespace {

std::string complaint(const std::vector<std::string>& changes) {
  try {
    refuse_changes_of_nothing(changes);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(GivenChanges, TextsWithoutAKeyAreRefused) {
  for (const auto& [change, found] : {std::pair{"# nothing", "--set: found `# nothing`"},
                                      {"   ", "--set: found `"},
                                      {"[powder]", "--set: found `[powder]`"},
                                      {"[powder.sizes]", "--set: found `[powder.sizes]`"}}) {
    const std::string message = complaint({change});
    EXPECT_NE(message.find(found), std::string::npos) << message;
    EXPECT_NE(message.find("changes no key; expected a key and its value"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_NE(complaint({"seed = 3", "# and no more"}), "");
}

TEST(GivenChanges, KeysAreTakenAloneAndBelowTheHeaderOfTheirTable) {
  EXPECT_EQ(complaint({}), "");
  EXPECT_EQ(complaint({"seed = 3 # as before"}), "");
  EXPECT_EQ(complaint({"[powder]", "friction = 0.3"}), "");
  EXPECT_EQ(complaint({"# of the powder\npowder.friction = 0.3"}), "");
  EXPECT_EQ(complaint({"step = []"}), "");
}

TEST(GivenChanges, OfWhatAnEarlierOneGivesAsAWholeAreRefusedWithTheRemedy) {
  const std::string message = complaint({"pour.from = [0, 0, 0]", "pour.from.0 = 2"});
  for (const char* part : {"--set:2:", "found `pour.from.0 = 2`", "an earlier change gives this key",
                           "as a whole: give the final value there"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(KeyPath, IsTheNameOfOneKeyAndNothingElse) {
  for (const char* key : {"seed", "powder.friction", "step.1.velocity", "tool.\"core rod\".position"})
    EXPECT_TRUE(is_key_path(key)) << key;
  for (const char* key : {"", "powder.friction = 3 #", "powder.friction #", "# powder.friction", "powder.",
                          "a b", "seed = 1\npowder.friction", "[powder]\nfriction"})
    EXPECT_FALSE(is_key_path(key)) << key;
}

}  // namespace
}  // namespace diefill::process
