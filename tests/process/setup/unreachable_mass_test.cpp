// Steps that wait for more powder than there is.
#include "process/setup/unreachable_mass.h"

#include <gtest/gtest.h>

#include "tests/process/box_tools.h"

namespace diefill::process {
namespace {

/// What is said of these steps where some 40 g are poured.
std::string complaint(const std::string& steps) {
  const BoxTools tools(table(), walls_around_the_pour(0.04), with_steps(steps));
  try {
    refuse_unreachable_mass(tools.scene, tools.tooling);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

std::string settling(const std::string& condition) {
  return "[[step]]\nkind = \"settle\"\n" + condition + "\n";
}

const std::string kFeed =
    "[[step]]\nkind = \"inflow\"\nfrom = [\"20 mm\", \"-10 mm\", \"0 mm\"]\nto = [\"50 mm\", \"10 mm\", \"90 "
    "mm\"]\n";

TEST(UnreachableMass, IsRefusedWithWhatThereIs) {
  for (const char* key : {"until", "start"}) {
    const std::string said = complaint(settling(std::string(key) + " = { filled_mass = \"500 g\" }"));
    for (const char* part : {"scene.toml:", key, "found a filled_mass of 500 g",
                             "all powder that is poured and let in "
                             "weighs ",
                             "would not end"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
  EXPECT_EQ(complaint(settling("until = { filled_mass = \"5 g\" }")), "");
}

TEST(UnreachableMass, CountsWhatStepsLetIn) {
  const std::string wait = settling("until = { filled_mass = \"500 g\" }");
  EXPECT_NE(complaint(kFeed + "mass = \"10 g\"\n" + wait), "");
  EXPECT_EQ(complaint(kFeed + "mass = \"490 g\"\n" + wait), "");
  EXPECT_EQ(complaint(kFeed + "until = { filled_mass = \"500 g\" }\n"), "") << "without limit";
}

TEST(UnreachableMass, OfAStepThatEndsByItselfIsNoObstacle) {
  EXPECT_EQ(
      complaint("[[step]]\nkind = \"wait\"\nduration = \"0.1 s\"\nuntil = { filled_mass = \"500 g\" }\n"),
      "");
}

}  // namespace
}  // namespace diefill::process
