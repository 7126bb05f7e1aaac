// Files appear whole or not at all, and leave nothing behind.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <thread>

#include "process/results/storage/atomic_file.h"
#include "process/results/storage/group_names.h"
#include "process/results/storage/result_file.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;
using support::contents;

std::ptrdiff_t files_in(const fs::path& directory) {
  return std::distance(fs::directory_iterator(directory), {});
}

TEST(AtomicFile, WritesAndReplaces) {
  const support::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "report.json";
  write_text_atomically(target, "first");
  EXPECT_EQ(contents(target), "first");
  const std::string binary("\0\n\xff second", 9);
  write_text_atomically(target, binary);
  EXPECT_EQ(contents(target), binary);
  EXPECT_EQ(files_in(scratch.path()), 1);
}

TEST(AtomicFile, TargetIsUntouchedWhileWriting) {
  const support::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "state";
  write_text_atomically(target, "old");
  write_atomically(target, [&](const fs::path& path) {
    EXPECT_EQ(path.parent_path(), scratch.path());
    EXPECT_NE(path, target);
    std::ofstream(path) << "new";
    EXPECT_EQ(contents(target), "old");
  });
  EXPECT_EQ(contents(target), "new");
}

TEST(AtomicFile, FailedWriteLeavesTheOldFileAndNothingElse) {
  const support::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "state";
  write_text_atomically(target, "old");
  const auto fail = [](const fs::path& path) {
    std::ofstream(path) << "half";
    throw std::runtime_error("No space left on device");
  };
  try {
    write_atomically(target, fail);
    ADD_FAILURE() << "no exception";
  } catch (const ResultError& error) {
    EXPECT_NE(std::string(error.what()).find(target.string()), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos);
  }
  EXPECT_EQ(contents(target), "old");
  EXPECT_EQ(files_in(scratch.path()), 1);
}

TEST(AtomicFile, TargetThatCannotBeReplacedIsAnError) {
  const support::TemporaryFolder scratch;
  fs::create_directory(scratch.path() / "state");
  EXPECT_THROW(write_text_atomically(scratch.path() / "state", "text"), ResultError);
  EXPECT_THROW(write_text_atomically(scratch.path() / "no" / "such" / "directory", "text"), ResultError);
  EXPECT_EQ(files_in(scratch.path()), 1);
}

TEST(AtomicFile, DirectoryWithoutPermissionKeepsItsFiles) {
  if (::geteuid() == 0) {  // nothing is forbidden to root; a file in place of the directory is
    const support::TemporaryFolder scratch;
    write_text_atomically(scratch.path() / "file", "text");
    EXPECT_THROW(write_results(scratch.path() / "file", sample_result()), ResultError);
    EXPECT_EQ(contents(scratch.path() / "file"), "text");
    return;
  }
  const support::TemporaryFolder scratch;
  write_text_atomically(scratch.path() / "state", "old");
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(write_text_atomically(scratch.path() / "state", "new"), ResultError);
  fs::permissions(scratch.path(), fs::perms::owner_all);
  EXPECT_EQ(contents(scratch.path() / "state"), "old");
  EXPECT_EQ(files_in(scratch.path()), 1);
}

TEST(AtomicFile, ManyWritersLeaveOneWholeFile) {
  const support::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "state";
  std::vector<std::thread> writers;
  for (char letter = 'a'; letter < 'e'; ++letter)
    writers.emplace_back([&, letter] {
      for (int n = 0; n < 5; ++n) write_text_atomically(target, std::string(100000, letter));
    });
  for (auto& writer : writers) writer.join();
  const std::string text = contents(target);
  EXPECT_EQ(text, std::string(100000, text.at(0)));
  EXPECT_EQ(files_in(scratch.path()), 1);
}

TEST(GroupNames, AreFitForPathsAndUnlikeEachOther) {
  EXPECT_EQ(group_names({"die", "upper punch", "a/b", "a b", ".", "", "a_b"}),
            (std::vector<std::string>{"die", "upper_punch", "a_b", "a_b_2", "_", "unnamed", "a_b_3"}));
}

}  // namespace
}  // namespace diefill::results
