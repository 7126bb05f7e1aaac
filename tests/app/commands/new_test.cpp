// `diefill new`: scenes to start from, and copies of scenes with changes.
#include <gtest/gtest.h>

#include "process/input/shell_word.h"
#include "project_paths.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

class NewKinds : public testing::TestWithParam<const char*> {};

TEST_P(NewKinds, WritesACommentedSceneWithToolsThatCanBeRead) {
  const support::TemporaryFolder folder;
  const std::string die = (folder.path() / "my_die").string();
  const Outcome outcome = run_program({"new", die, "--kind", GetParam()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("diefill run " + die + "/fill.toml"), std::string::npos) << outcome.out;
  EXPECT_NE(contents(die + "/fill.toml").find("# "), std::string::npos);
  EXPECT_EQ(run_program({"estimate", die + "/fill.toml"}).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(New, NewKinds, testing::Values("rectangular_die", "ring", "gear"));

TEST(New, PrintsACommandThatAShellTakes) {
  const support::TemporaryFolder folder;
  const std::string die = (folder.path() / "my die").string();
  const Outcome outcome = run_program({"new", die});
  // The program was started by its path, so that path stands in the command.
  const std::string command = process::shell_word(DIEFILL_PROGRAM) + " run '" + die + "/fill.toml'\n";
  EXPECT_TRUE(outcome.out.ends_with("run it with: " + command)) << outcome.out;
}

TEST(New, OverwritesNothing) {
  const support::TemporaryFolder folder;
  folder.write("mine", "mine");
  const Outcome outcome = run_program({"new", (folder.path() / "mine").string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_EQ(contents(folder.path() / "mine"), "mine");
  EXPECT_EQ(SmallDie::files_in(folder.path()).size(), 1U);
}

TEST(New, CopiesASceneWithChanges) {
  const SmallDie die;
  const std::string copy = (die.folder() / "copy").string();
  const Outcome outcome = run_program({"new", copy, "--from", die.scene().string(), "--set",
                                       "step.1.velocity = \"0.05 m/s\"", "--set", "seed = 7"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = contents(copy + "/fill.toml");
  EXPECT_NE(text.find("0.05 m/s"), std::string::npos) << text;
  EXPECT_NE(text.find("seed = 7"), std::string::npos) << text;
  EXPECT_EQ(run_program({"estimate", copy + "/fill.toml"}).exit_code, 0);
}

TEST(New, RefusesAChangeOfAKeyThatThereIsNot) {
  const SmallDie die;
  const fs::path copy = die.folder() / "copy";
  const Outcome outcome =
      run_program({"new", copy.string(), "--from", die.scene().string(), "--set", "powder.grain_size = 1"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("grain_size"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(copy));
}

TEST(New, NamesTheWantedPlaceWhereNothingCanBeWritten) {
  const Outcome outcome = run_program({"new", "/proc/x"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("/proc/x: cannot be written: "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find(".tmp"), std::string::npos) << outcome.err;
}

TEST(SceneChanges, HoldForARun) {
  const SmallDie die;
  const Outcome outcome = die.run({"--no-pictures", "--set", "step.1.velocity = \"0.3 m/s\""});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(die.report()["strategy"].get<std::string>().find("0.3 m/s"), std::string::npos);
}

}  // namespace
}  // namespace diefill::app
