// Every wrong scene through the real program: one line that says what is wrong, exit code 2, and nothing
// written.
#include "tests/process/wrong_scenes.h"

#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/app/small_die.h"
#include "tests/process/scene_files.h"

namespace diefill::app {
namespace {

TEST(WrongScenes, EndInOneLineAndWriteNothing) {
  const process::SceneFolder folder;
  const auto all = process::wrong_scenes();
  constexpr std::size_t kEvery = 8;  // the reader's own tests have them all; here each starts the program
  for (std::size_t k = 0; k < all.size(); k += kEvery) {
    const process::WrongScene& wrong = all[k];
    SCOPED_TRACE(wrong.name);
    const auto file = folder.write(wrong.text);
    const auto files_before = SmallDie::files_in(folder.path());
    const Outcome outcome = run_program({"check", file.string()}, {folder.path(), {}});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    for (const std::string& part : wrong.expected)
      EXPECT_NE(outcome.err.find(part), std::string::npos)
          << "missing: " << part << "\nin:      " << outcome.err;
    EXPECT_EQ(SmallDie::files_in(folder.path()), files_before);
  }
}

TEST(WrongScenes, StopARunBeforeItMakesItsDirectory) {
  const process::SceneFolder folder;
  const auto file = folder.write(process::wrong_scenes().front().text);
  const Outcome outcome = run_program({"run", file.string()}, {folder.path(), {}});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace diefill::app
