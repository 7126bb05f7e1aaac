// `diefill film`: frames of the filling, in order, and the film beside the results.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Film, DrawsEveryInstantAndTheEnd) {
  const SmallDie die;
  die.write("scene.toml", contents(die.scene()) + "snapshot_interval = \"20 ms\"\n");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
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

TEST(Film, RefusesWhatItCannotShow) {
  const SmallDie die;
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const std::string out = die.out().string();
  const Outcome still = run_program({"film", out});
  EXPECT_EQ(still.exit_code, 2);
  EXPECT_NE(still.err.find("measure.snapshot_interval"), std::string::npos) << still.err;
  const Outcome many = run_program({"film", out, out, out, out, out});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_NE(many.err.find("found 5 directories"), std::string::npos) << many.err;
  const Outcome name = run_program({"film", out, "--out", "film.avi"});
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_NE(name.err.find("ends in .mp4"), std::string::npos) << name.err;
}

}  // namespace
}  // namespace diefill::app
