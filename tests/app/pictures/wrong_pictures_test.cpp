// Options of pictures, exports and reports that are wrong: one line, and nothing is written or overwritten.
#include <algorithm>
#include <fstream>

#include "tests/app/pictures/every_picture.h"

namespace diefill::app {
namespace {

using WrongPictures = EveryPicture;

TEST_F(WrongPictures, ExportRefusesFilesAsDirectoriesAndOptionsWithoutEffect) {
  const fs::path file = one() / "file", grown = one() / "new";
  std::ofstream(file) << "mine";
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--out", file.string()}, "is a file, not a directory"},
      {{"--out", (file / "below").string()}, "is a file, not a directory"},
      {{"--averaging-width", "1 nm"}, "from a tenth of a grain"},
      {{"--averaging-width", "1 km"}, "to the largest edge of the cavity"},
      {{"--mesh-share", "0.5"}, "--mesh-share: has no effect without --density-for"},
      {{"--mesh-unit", "m"}, "--mesh-unit: has no effect without --density-for"},
      {{"--mass", "1 g"}, "--mass: has no effect without --density-for or --density-grid"},
      {{"--cavity", "1"}, "--cavity: has no effect without --density-for or --density-grid"},
      {{"--mesh-position", "0 mm", "0 mm", "0 mm", "--density-grid", "1 mm"},
       "--mesh-position: has no effect"},
      {{"--mesh-share", "nan", "--density-for", "a.inp"}, "--mesh-share: found \"nan\""},
      {{"--mesh-share", "inf", "--density-for", "a.inp"}, "--mesh-share: found \"inf\""},
      {{"--density-grid", "10 m"}, "--density-grid: found \"10 m\", allowed: more than 0, at most 16 mm"},
      {{"--density-grid", "1 nm", "--mass", "1 g"}, "20 million cells"},
  };
  for (const auto& [more, expected] : wrong) {
    SCOPED_TRACE(expected);
    std::vector<std::string> arguments = {"export", one().string()};
    if (more.front() != "--out") arguments.insert(arguments.end(), {"--out", grown.string()});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_FALSE(fs::exists(grown));
  }
  EXPECT_EQ(support::contents(file), "mine");
}

TEST_F(WrongPictures, ReportOverwritesNothingThatItReads) {
  const std::string before = support::contents(one() / "results.h5");
  fs::create_hard_link(one() / "results.h5", one() / "link.html");
  fs::create_directory(one() / "folder.html");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& expected) {
    std::vector<std::string> arguments = {"report", one().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << expected;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
  };
  refused({"--out", (one() / "results.h5").string()}, "a file that ends in .html or .htm");
  refused({"--out", (one() / "link.html").string()}, "which the command reads");
  refused({"--out", (one() / "folder.html").string()}, "which is a directory");
  refused({"--out", (one() / "results.h5" / "page.html").string()}, "is a file, not a directory");
  refused({one().string()}, "which are the same results");
  refused({two().string(), (two() / ".." / "one").string()}, "which are the same results");
  EXPECT_EQ(support::contents(one() / "results.h5"), before);
}

TEST_F(WrongPictures, NoDirectoryIsLeftWhereNothingCanBeDrawn) {
  const fs::path above = one().parent_path() / "drawn", out = above / "deep";
  const std::vector<std::vector<std::string>> wrong = {
      {"--picture", "difference", "--from", "9 s"},
      {"--picture", "section", "--origin", "0 mm", "0 mm", "40 mm"},
      {"--picture", "probe", "--y", "piston/F_z"}};
  for (const auto& arguments : wrong) {
    SCOPED_TRACE(arguments[1]);
    std::vector<std::string> command = {"map", one().string(), "--out", out.string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    EXPECT_EQ(run_program(command).exit_code, 2);
    EXPECT_FALSE(fs::exists(above));
  }
  // One that was there stays, and so does what is drawn.
  fs::create_directories(above);
  EXPECT_EQ(run_program(
                {"map", one().string(), "--out", above.string(), "--picture", "difference", "--from", "9 s"})
                .exit_code,
            2);
  EXPECT_TRUE(fs::is_directory(above));
  EXPECT_EQ(run_program({"map", one().string(), "--out", out.string(), "--picture", "section"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(out / "section.png"));
}

TEST_F(WrongPictures, OptionsWithoutEffectAreRefused) {
  std::ofstream(one() / "level.csv") << "azimuth [deg], fill level [mm]\n45, 3\n";
  const std::string level = (one() / "level.csv").string();
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--picture", "histogram", "--to", "0 s"},
       "--to: has no effect without --time-average or --picture difference, displacement, view"},
      {{"--picture", "velocity", "--from", "0 s"}, "--from: has no effect without --time-average"},
      {{"--picture", "view", "--from", "0 s"}, "--from: has no effect without"},
      {{"--picture", "histogram", "--origin", "0 mm", "0 mm", "0 mm"}, "--origin: has no effect without"},
      {{"--picture", "map", "--normal", "z"}, "--normal: has no effect without --picture section"},
      {{"--picture", "histogram", "--range", "0.3", "0.4"}, "--range: has no effect without"},
      {{"--picture", "map", "--colour-by", "speed"}, "--colour-by: has no effect without --picture view"},
      {{"--camera", "top"}, "--camera: has no effect without --picture view, frames"},
      {{"--measured", level, "--from", "0 s"}, "--from: has no effect with --measured"},
      {{"--measured", level, "--picture", "map"}, "--measured: found --picture map, allowed: one results"},
      {{"--measured", level, "--x", "time"}, "--measured: found --x, allowed: one results directory"},
  };
  for (const auto& [arguments, expected] : wrong) {
    SCOPED_TRACE(expected);
    const Outcome outcome = map(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(out()));
  }
  const Outcome two_results = map({"--measured", level}, true);
  EXPECT_NE(two_results.err.find("--measured: found 2 results directories"), std::string::npos)
      << two_results.err;
  // One of several kinds uses it.
  EXPECT_EQ(map({"--picture", "histogram", "--picture", "map", "--range", "0.3", "0.6"}).exit_code, 0);
}

TEST_F(WrongPictures, WrongWordsAreExplainedInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--picture", "hystogram"}, "did you mean \"histogram\"?"},
      {{"--picture", "section", "--normal", "0,0,0"}, "three numbers not all 0"},
      {{"--picture", "section", "--normal", "1e-320,0,0"}, "three numbers not all 0 and of sizes near 1"},
      {{"--picture", "view", "--camera", "behind"}, "azimuth and elevation"},
      {{"--picture", "difference", "--from", "9 s"}, "the results contain 2 from 0.1 s to 0.2 s"},
      {{"--picture", "displacement", "--from", "0.2 s", "--to", "0.1 s"}, "must come before"},
      {{"--picture", "map", "--range", "0.4", "0.3"}, "must be less than"},
      {{"--picture", "map", "--range", "nan", "nan"},
       "--range: found \"nan\", allowed: a number from -1e+09 to 1e+09"},
      {{"--picture", "map", "--range", "-1e308", "1e308"}, "--range: found \"-1e308\""},
      {{"--picture", "map", "--range", "0.3", "inf"}, "--range: found \"inf\""},
      {{"--picture", "map", "--range", "0.3", "1e999"}, "--range: found \"1e999\""},
      {{"--picture", "map", "--averaging-width", "1 nm"}, "from a tenth of a grain"},
      {{"--picture", "map", "--averaging-width", "1 km"}, "to 16 mm"},
      {{"--picture", "section", "--origin", "1e9 m", "0 m", "0 m"}, "--origin: found \"1e9 m\""},
      {{"--picture", "section", "--origin", "0 mm", "0 mm", "40 mm"}, "outside die and powder"},
      {{"--picture", "difference", "--from", "-1 s"}, "--from: found \"-1 s\", allowed: 0 s to"},
      {{"--picture", "map", "--cavity", "0"}, "--cavity: found \"0\""},
      {{"--picture", "histogramm"}, "did you mean \"histogram\"? (allowed: map, plan-map, "},
      {{"--picture", "view", "--colour-by", "sped"}, "did you mean \"speed\"?"},
      {{"--picture", "view", "--camera", "frnt"}, "did you mean \"front\""},
      {{"--picture", "view", "--time-average"}, "shows one instant; allowed: map plan-map section"},
      {{"--picture", "map", "--time-average", "--from", "0.25 s"}, "at least two instants"},
  };
  for (const auto& [arguments, expected] : wrong) {
    SCOPED_TRACE(expected);
    const Outcome outcome = map(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace diefill::app
