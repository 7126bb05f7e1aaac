// The sample tools are found beside an installed program and in the source tree of a build, and nowhere else.
#include "process/input/sample_tools.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

/// Makes the folder `name` in `folder` and returns it.
fs::path made(const support::TemporaryFolder& folder, const char* name) {
  fs::create_directories(folder.path() / name);
  return fs::canonical(folder.path() / name);
}

TEST(SampleTools, OfAnInstalledProgramLieInItsShare) {
  const support::TemporaryFolder prefix;
  const fs::path program = made(prefix, "usr/bin"), share = made(prefix, "usr/share/diefill/sample_tools");
  made(prefix, "sample_tools");  // of somebody else
  prefix.write("CMakeLists.txt", "");
  EXPECT_EQ(sample_tools_beside(program), share);
  EXPECT_FALSE(in_source_tree(share));
}

TEST(SampleTools, OfABuildLieInItsSourceTree) {
  const support::TemporaryFolder tree;
  const fs::path program = made(tree, "build/bin"), tools = made(tree, "sample_tools");
  EXPECT_EQ(sample_tools_beside(program), "sample_tools");  // no source tree
  tree.write("CMakeLists.txt", "");
  EXPECT_EQ(sample_tools_beside(program), tools);
  EXPECT_TRUE(in_source_tree(tools));
}

TEST(SampleTools, AreElseThoseOfTheCurrentFolder) {
  const support::TemporaryFolder folder;
  EXPECT_EQ(sample_tools_beside(made(folder, "usr/bin")), "sample_tools");
}

}  // namespace
}  // namespace diefill::process
