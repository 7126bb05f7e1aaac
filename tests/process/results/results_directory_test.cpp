// A results directory has one writer, keeps what earlier runs have left, and loses what killed runs have
// left.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "process/results/storage/atomic_file.h"
#include "process/results/storage/directory_lock.h"
#include "process/results/storage/earlier_results.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;
using support::contents;

/// The message to a second process that tries to lock the directory; empty: it was locked.
std::string told_another_process(const fs::path& directory) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  if (::fork() == 0) {
    std::string told;
    try {
      const DirectoryLock lock(directory);
    } catch (const DirectoryInUse& error) {
      told = error.what();
    }
    ::_exit(::write(ends[1], told.data(), told.size()) < 0 ? 1 : 0);
  }
  ::close(ends[1]);
  char text[500];
  const ssize_t length = ::read(ends[0], text, sizeof text);
  ::close(ends[0]);
  ::wait(nullptr);
  return {text, static_cast<std::size_t>(std::max<ssize_t>(length, 0))};
}

TEST(DirectoryLock, KeepsOtherProcessesOutForItsLife) {
  const support::TemporaryFolder folder;
  {
    const DirectoryLock lock(folder.path());
    const std::string told = told_another_process(folder.path());
    EXPECT_NE(told.find("process " + std::to_string(::getpid())), std::string::npos) << told;
    EXPECT_NE(told.find("locked"), std::string::npos) << told;
  }
  EXPECT_EQ(told_another_process(folder.path()), "");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(DirectoryLock, OfAKilledProcessMeansNothing) {
  const support::TemporaryFolder folder;
  folder.write(".lock", "");
  EXPECT_FALSE(lock_holder(folder.path()).has_value());
  EXPECT_EQ(told_another_process(folder.path()), "");
}

TEST(EarlierResults, AreMovedAsideAndNothingElse) {
  const support::TemporaryFolder folder;
  const fs::path& out = folder.path();
  EXPECT_FALSE(set_aside(out).has_value());
  fs::create_directory(out / "snapshots");
  for (const char* name : {"results.h5", "report.json", "density_map.png", "probe_on punch.csv", "fill.toml",
                           "die.stl", "motion.csv", "snapshots/early"})
    folder.write(name, name);
  EXPECT_EQ(set_aside(out), out / "previous-1");
  for (const char* name :
       {"results.h5", "report.json", "density_map.png", "probe_on punch.csv", "snapshots/early"}) {
    EXPECT_EQ(contents(out / "previous-1" / name), name);
    EXPECT_FALSE(fs::exists(out / name)) << name;
  }
  for (const char* name : {"fill.toml", "die.stl", "motion.csv"}) EXPECT_EQ(contents(out / name), name);
  folder.write("checkpoint.bin", "another");
  EXPECT_EQ(set_aside(out), out / "previous-2");
  EXPECT_EQ(contents(out / "previous-2" / "checkpoint.bin"), "another");
  EXPECT_EQ(contents(out / "previous-1" / "results.h5"), "results.h5");
}

TEST(AbandonedFiles, OfProcessesThatAreNoMoreAreRemoved) {
  const support::TemporaryFolder folder;
  const std::string other_program = "results.h5.1-0.tmp", none = "results.h5.999999999-3.tmp",
                    parent = "report.json." + std::to_string(::getppid()) + "-0.tmp";
  for (const std::string& name :
       {other_program, none, parent, std::string("notes.tmp"), std::string("a.1-0")})
    folder.write(name, "");
  const pid_t sibling = ::fork();
  if (sibling == 0) {
    ::pause();
    ::_exit(0);
  }
  const std::string at_work = "checkpoint.bin." + std::to_string(sibling) + "-0.tmp";
  folder.write(at_work, "");
  remove_abandoned_files(folder.path());
  EXPECT_TRUE(fs::exists(folder.path() / at_work));
  EXPECT_FALSE(fs::exists(folder.path() / none));
  EXPECT_TRUE(fs::exists(folder.path() / "notes.tmp"));
  EXPECT_TRUE(fs::exists(folder.path() / "a.1-0"));
  ::kill(sibling, SIGKILL);
  ::waitpid(sibling, nullptr, 0);
  remove_abandoned_files(folder.path());
  EXPECT_FALSE(fs::exists(folder.path() / at_work));
}

}  // namespace
}  // namespace diefill::results
