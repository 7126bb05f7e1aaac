// `diefill film`: frames of the filling, in order, and the film beside the results.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

/// Results with instants: few, because each frame is drawn at full size, whatever the film's width.
void take_results_with_instants(const SmallDie& die) {
  die.write("scene.toml", contents(die.scene()) + "snapshot_interval = \"100 ms\"\n");
  take_shared_results(die);
}

TEST(Film, DrawsEveryInstantAndTheEnd) {
  const SmallDie die;
  take_results_with_instants(die);
  const Outcome outcome = run_program({"film", die.out().string(), "--keep-frames", "--width", "400",
                                       "--tools", "translucent", "--colour-by", "speed", "--jobs", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto frames = SmallDie::files_in(die.out() / "film_frames");
  ASSERT_GT(frames.size(), 5U);
  EXPECT_EQ(frames.front(), "00000.png");
  EXPECT_NE(contents(die.out() / "film_frames" / frames.front()),
            contents(die.out() / "film_frames" / frames.back()));
  // Where ffmpeg is installed the report holds the film; elsewhere one line says what is missing.
  const bool film = std::filesystem::exists(die.out() / "film.mp4");
  EXPECT_EQ(outcome.complaints(), film ? 0U : 1U) << outcome.err;
  ASSERT_EQ(run_program({"report", die.out().string()}).exit_code, 0);
  EXPECT_EQ(contents(die.out() / "report.html").find("<video") != std::string::npos, film);
}

/// Results with instants, and what is in their folder.
class Filmed : public testing::Test {
 protected:
  Filmed() { take_results_with_instants(die_); }
  std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {
        "film", die_.out().string(), "--width", "400", "--out", (die_.folder() / "my.mp4").string(), "--jobs",
        "2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  SmallDie die_;
};

TEST_F(Filmed, DeletesNoFolderOfOthers) {
  const auto folder = die_.folder() / "my_frames";
  std::filesystem::create_directory(folder);
  die_.write("my_frames/thesis.txt", "mine");
  const Outcome kept = run_program(arguments({"--keep-frames"}));
  EXPECT_EQ(kept.exit_code, 2);
  EXPECT_EQ(kept.complaints(), 1U) << kept.err;
  EXPECT_NE(kept.err.find("such as \"thesis.txt\""), std::string::npos) << kept.err;
  run_program(arguments());
  EXPECT_EQ(contents(folder / "thesis.txt"), "mine");
  EXPECT_EQ(SmallDie::files_in(folder).size(), 1U);
  // Earlier frames may be someone's too: they make room and stay.
  std::filesystem::remove(folder / "thesis.txt");
  die_.write("my_frames/00000.png", "mine");
  const Outcome again = run_program(arguments({"--keep-frames"}));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(contents(die_.folder() / "my_frames-previous-1" / "00000.png"), "mine");
  EXPECT_GT(SmallDie::files_in(folder).size(), 5U);
}

/// Programs whose command line holds `word`.
int programs_with(const std::string& word) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream words(entry.path() / "cmdline");  // nothing of what is no program, or has just ended
    const std::string line{std::istreambuf_iterator<char>(words), std::istreambuf_iterator<char>()};
    if (line.find(word) != std::string::npos) ++count;
  }
  return count;
}

TEST_F(Filmed, EndsWithItsWorkersAndLeavesNoFrames) {
  const std::string film = (die_.folder() / "my.mp4").string();
  for (const int signal : {SIGKILL, SIGTERM}) {
    SCOPED_TRACE(signal);
    Program program(arguments({"--turntable"}));
    const auto until = [](auto reached) {
      constexpr int kMax = 6000;
      for (int n = 0; n < kMax && !reached(); ++n) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      return reached();
    };
    ASSERT_TRUE(until([&] { return programs_with(film) == 3; }));
    program.send(signal);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, signal == SIGTERM ? 130 : -1);
    EXPECT_TRUE(until([&] { return programs_with(film) == 0; }));
    EXPECT_FALSE(std::filesystem::exists(film));
  }
  // The frames of the one that was killed are gone with those of the next.
  for (const std::string& name : SmallDie::files_in(die_.folder()))
    EXPECT_FALSE(name.starts_with("my_frames")) << name;
}

TEST(Film, RefusesWhatItCannotShow) {
  const SmallDie die;
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const std::string out = die.out().string();
  const Outcome still = run_program({"film", out});
  EXPECT_EQ(still.exit_code, 2);
  EXPECT_NE(still.err.find("measure.snapshot_interval"), std::string::npos) << still.err;
  const auto above = die.folder() / "films";
  EXPECT_EQ(run_program({"film", out, "--out", (above / "deep/still.mp4").string()}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(above));
  const Outcome many = run_program({"film", out, out, out, out, out});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_NE(many.err.find("found 5 directories"), std::string::npos) << many.err;
  const Outcome twice = run_program({"film", out, out, "--turntable"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.err.find("which are the same results"), std::string::npos) << twice.err;
  const Outcome name = run_program({"film", out, "--out", "film.avi"});
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_NE(name.err.find("ends in .mp4"), std::string::npos) << name.err;
}

}  // namespace
}  // namespace diefill::app
