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
    std::string reported;
    try {
      const DirectoryLock lock(directory);
    } catch (const DirectoryInUse& error) {
      reported = error.what();
    }
    ::_exit(::write(ends[1], reported.data(), reported.size()) < 0 ? 1 : 0);
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
    const std::string reported = told_another_process(folder.path());
    EXPECT_NE(reported.find("process " + std::to_string(::getpid())), std::string::npos) << reported;
    EXPECT_NE(reported.find("locked"), std::string::npos) << reported;
  }
  EXPECT_EQ(told_another_process(folder.path()), "");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(DirectoryLock, OfAKilledProcessMeansNothing) {
  const support::TemporaryFolder folder;
  folder.write(".diefill-lock", "");
  EXPECT_FALSE(lock_holder(folder.path()).has_value());
  EXPECT_EQ(told_another_process(folder.path()), "");
}

/// What another process finds.
bool left_for_another_process(const fs::path& directory) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(left_by_a_killed_process(directory) ? 1 : 0);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WEXITSTATUS(status) == 1;
}

TEST(DirectoryLock, OfAKilledProcessTellsWhatItHasLeft) {
  const support::TemporaryFolder folder;
  EXPECT_FALSE(left_for_another_process(folder.path()));
  {
    const DirectoryLock lock(folder.path());
    EXPECT_FALSE(left_for_another_process(folder.path()));
  }
  EXPECT_FALSE(left_for_another_process(folder.path()));
  folder.write(".diefill-lock", "");
  EXPECT_TRUE(left_for_another_process(folder.path()));
}

TEST(EarlierResults, AreMovedAsideAndNothingElse) {
  const support::TemporaryFolder folder;
  const fs::path& out = folder.path();
  EXPECT_FALSE(back_up_results(out).has_value());
  fs::create_directory(out / "snapshots");
  for (const char* name : {"results.h5", "report.json", "density_map.png", "probe_on punch.csv", "fill.toml",
                           "die.stl", "motion.csv", "snapshots/early"})
    folder.write(name, name);
  EXPECT_EQ(back_up_results(out), out / "previous-1");
  for (const char* name :
       {"results.h5", "report.json", "density_map.png", "probe_on punch.csv", "snapshots/early"}) {
    EXPECT_EQ(contents(out / "previous-1" / name), name);
    EXPECT_FALSE(fs::exists(out / name)) << name;
  }
  for (const char* name : {"fill.toml", "die.stl", "motion.csv"}) EXPECT_EQ(contents(out / name), name);
  folder.write("checkpoint.bin", "another");
  EXPECT_EQ(back_up_results(out), out / "previous-2");
  EXPECT_EQ(contents(out / "previous-2" / "checkpoint.bin"), "another");
  EXPECT_EQ(contents(out / "previous-1" / "results.h5"), "results.h5");
}

TEST(EarlierResults, IncludeTheSeriesForParaView) {
  const support::TemporaryFolder folder;
  for (const char* name : {"results.h5", "filling.pvd"}) folder.write(name, name);
  EXPECT_EQ(back_up_results(folder.path()), folder.path() / "previous-1");
  EXPECT_EQ(contents(folder.path() / "previous-1/filling.pvd"), "filling.pvd");
  EXPECT_FALSE(fs::exists(folder.path() / "filling.pvd"));
}

TEST(EarlierResults, IncludePicturesByTheNamesOfThisProgram) {
  const support::TemporaryFolder folder;
  const std::vector<std::string> own = {"section.png",      "section_2.png", "density_map_cavity_12.png",
                                        "plan_map.png",     "histogram.pdf", "report.pdf",
                                        "film.mp4",         "live.html",     "results.xdmf",
                                        "film_fast.mp4",    "frames_fast",   "frames",
                                        "checkpoint.inputs"};
  for (const char* frames : {"frames", "frames_fast"}) {
    fs::create_directory(folder.path() / frames);
    folder.write(std::string(frames) + "/00000.png", "frame");
  }
  for (const auto& name : own)
    if (!name.starts_with("frames")) folder.write(name, name);
  EXPECT_EQ(back_up_results(folder.path()), folder.path() / "previous-1");
  for (const auto& name : own) EXPECT_TRUE(fs::exists(folder.path() / "previous-1" / name)) << name;
  EXPECT_EQ(contents(folder.path() / "previous-1/section_2.png"), "section_2.png");
  EXPECT_FALSE(back_up_results(folder.path()).has_value());
}

TEST(EarlierResults, LeavePicturesOfOthers) {
  const support::TemporaryFolder folder;
  fs::create_directory(folder.path() / "camera_frames");
  const std::vector<std::string> foreign = {
      "photo.png",        "data sheet.pdf", "press.mp4",    "section_of_the_die.png", "map_fast.png",
      "film_of_ours.mp4", "section.svg",    "cavity_2.png", "measured_level.png",     "measured_level.csv",
      "notes.txt",        "_2.png",         "2.png",        "camera_frames/a.png"};
  for (const auto& name : foreign) folder.write(name, name);
  EXPECT_FALSE(back_up_results(folder.path()).has_value());
  for (const auto& name : foreign) EXPECT_EQ(contents(folder.path() / name), name);
}

TEST(EarlierResults, IncludeComparisonsWithMeasuredData) {
  const support::TemporaryFolder folder;
  const std::string heading = "\"x [mm]\",\"measured level [mm]\",\"simulated level [mm]\"\n";
  const std::vector<std::string> own = {"measured_level.csv", "measured_level_zones.csv",
                                        "measured_level.png", "measured_level_difference.png"};
  for (const auto& name : own) folder.write(name, heading);
  EXPECT_EQ(back_up_results(folder.path()), folder.path() / "previous-1");
  for (const auto& name : own) EXPECT_TRUE(fs::exists(folder.path() / "previous-1" / name)) << name;
}

TEST(EarlierResults, WouldMoveTheDirectoryAndWhatARunLeftInIt) {
  const support::TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  fs::create_directories(out / "snapshots/early");
  fs::create_directories(out / "previous-1");
  EXPECT_TRUE(would_be_moved(out, out));
  EXPECT_TRUE(would_be_moved(out, folder.path() / "other/../out"));
  EXPECT_TRUE(would_be_moved(out, out / "snapshots/early"));
  EXPECT_FALSE(would_be_moved(out, out / "previous-1"));
  EXPECT_FALSE(would_be_moved(out, folder.path()));
  EXPECT_FALSE(would_be_moved(out, folder.path() / "out-2"));
}

TEST(DirectoryLock, LeavesALockFileOfOthersInPlace) {
  const support::TemporaryFolder folder;
  folder.write(".lock", "mine");
  { const DirectoryLock lock(folder.path()); }
  EXPECT_EQ(contents(folder.path() / ".lock"), "mine");
}

TEST(AbandonedFiles, AreKnownByTheNameThatThisProgramGives) {
  const support::TemporaryFolder folder;
  for (const char* name : {"data.2024-11.tmp", "picture.png.diefill-999999999-0.tmp"}) folder.write(name, "");
  remove_abandoned_files(folder.path());
  EXPECT_TRUE(fs::exists(folder.path() / "data.2024-11.tmp"));
  EXPECT_FALSE(fs::exists(folder.path() / "picture.png.diefill-999999999-0.tmp"));
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
