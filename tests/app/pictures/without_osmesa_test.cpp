// Where OSMesa cannot be opened, pictures say what to install; what draws nothing does not ask for it.
#include <gtest/gtest.h>

#include "project_paths.h"
#include "tests/app/small_die.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {
namespace {

TEST(WithoutOsmesa, PicturesNameThePackageAndOtherCommandsRun) {
  const support::TemporaryFolder folder;
  folder.write("libOSMesa.so.8", "");
  const auto run = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {"LD_LIBRARY_PATH=" + folder.path().string(), DIEFILL_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Surroundings surroundings;
    surroundings.program = "/usr/bin/env";
    return run_program(words, surroundings);
  };
  const SmallDie die;
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const std::string results = die.out().string();
  const auto pictures = folder.path() / "pictures";
  const Outcome map = run({"map", results, "--out", pictures.string()});
  EXPECT_EQ(map.exit_code, 1);
  EXPECT_EQ(map.complaints(), 1U) << map.err;
  EXPECT_NE(map.err.find("install the package libosmesa6"), std::string::npos) << map.err;
  EXPECT_FALSE(std::filesystem::exists(pictures));
  EXPECT_EQ(run({"info", results}).exit_code, 0);
}

}  // namespace
}  // namespace diefill::app
