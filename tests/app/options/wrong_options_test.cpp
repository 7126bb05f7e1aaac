// Words of the command line that are wrong for every command alike: empty, unknown, no numbers, files that
// are none. Each is refused in one line with exit code 2, and nothing is written.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void expect_refused(const Words& arguments, const Words& parts, const fs::path& where) {
  SCOPED_TRACE(testing::PrintToString(arguments));
  const Outcome outcome = run_program(arguments, {where, {}});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  for (const auto& part : parts) EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

/// A die whose folder must be the same at the end.
class WrongOptions : public testing::Test {
 protected:
  void refused(const Words& arguments, const Words& parts) const {
    const auto before = SmallDie::files_in(die_.folder());
    expect_refused(arguments, parts, die_.folder());
    EXPECT_EQ(SmallDie::files_in(die_.folder()), before);
  }
  std::string scene() const { return die_.scene().string(); }

  SmallDie die_;
};

TEST_F(WrongOptions, EmptyWordsAreNoValues) {
  refused({"run", scene(), "--out", ""}, {"--out: found an empty text"});
  refused({"run", scene(), "--out", "  "}, {"--out: found an empty text"});
  refused({"run", scene(), "--out="}, {"--out: no value after ="});
  refused({"check", scene(), "--set", ""}, {"--set: found an empty text"});
  refused({"run", scene(), "--setting", ""}, {"--setting: found an empty text"});
  refused({"plan", scene(), "--setting", ""}, {"--setting: found an empty text"});
  refused({"export", "out", "--mesh-position", "0 mm", "", "0 mm"}, {"--mesh-position: found an empty text"});
  refused({"new", ""}, {"argument 2: found an empty text"});
  refused({"check", ""}, {"argument 2: found an empty text"});
  refused({""}, {"argument 1: found an empty text"});
}

TEST_F(WrongOptions, UnknownWordsAreNamedWithTheNearest) {
  refused({"frob"}, {"diefill: unknown command: found \"frob\"", "allowed: new, run, check"});
  refused({"chekc", scene()}, {"found \"chekc\"; did you mean \"check\"?"});
  refused({"lab", "mean_fraction"},
          {"diefill lab: unknown experiment: found \"mean_fraction\"", "did you mean \"mean_fractions\"?"});
  refused({"lab", "stab"}, {"unknown experiment: found \"stab\"; did you mean \"stability\"?"});
  refused({"run", scene(), "--thr", "2"}, {"unknown option \"--thr\"; did you mean --threads?"});
  refused({"lab", "walls", "reboud"}, {"unknown experiment: found \"reboud\"; did you mean \"rebound\"?"});
  refused({"--vresion"}, {"diefill: unknown option \"--vresion\"; did you mean --version?"});
  refused({"run", scene(), "--theads", "2"},
          {"diefill run: unknown option \"--theads\"; did you mean --threads?"});
  refused({"run", "--theads=2", scene()}, {"unknown option \"--theads\"; did you mean --threads?"});
  refused({"run", scene(), "-threads", "2"}, {"unknown option \"-threads\"; did you mean --threads?"});
  refused({"check", scene(), "--qqqqq"}, {"unknown option \"--qqqqq\" (allowed: ", "--picture"});
  refused({"check", scene(), "more"}, {"found \"more\"", "its arguments are SCENE"});
  refused({"new", "die", "--kind", "rng"}, {"--kind: found \"rng\"; did you mean \"ring\"?", "gear"});
  refused({"lab", "silo", "--size", "corse"}, {"--size: found \"corse\"; did you mean \"coarse\"?"});
  refused({"--completion", "fish"}, {"--completion: found \"fish\" (allowed: bash, zsh)"});
  refused({"map", "out", "--picture", "histgram"}, {"did you mean \"histogram\"?"});
  refused({"run", scene(), "--renderer", "embre"}, {"--renderer: found \"embre\"; did you mean \"embree\"?"});
}

TEST_F(WrongOptions, OptionsOfRunsDoNotGoWithExportedJobs) {
  for (const std::string option : {"--resume", "--jobs", "--threads"}) {
    Words words = {"calibrate", scene(), "--export-jobs", "jobs", option};
    if (option != "--resume") words.push_back("2");
    refused(words, {"--export-jobs", option});
  }
}

TEST_F(WrongOptions, NumbersAreFiniteAndWithinTheirLimits) {
  // What is no number is told by one check for real and one for whole numbers; each option has limits of its
  // own.
  for (const std::string number : {"nan", "NaN", "inf", "-inf", "1e999", "many", "-1"}) {
    const std::string found = ": found \"" + number + "\"";
    refused({"lab", "silo", "--budget=" + number}, {"--budget" + found, "above 0"});
    refused({"run", scene(), "--threads=" + number}, {"--threads" + found, "a whole number from 1 to 1024"});
  }
  for (const std::string number : {"nan", "inf", "-1"}) {
    const std::string found = ": found \"" + number + "\"";
    refused({"tradeoff", scene(), "--budget=" + number}, {"--budget" + found});
    refused({"tradeoff", scene(), "--tolerance=" + number}, {"--tolerance" + found, "0 to 100"});
    refused({"calibrate", scene(), "--budget=" + number}, {"--budget" + found});
    refused({"plan", scene(), "--minutes=" + number}, {"--minutes" + found});
    refused({"plan", scene(), "--error=" + number}, {"--error" + found});
    refused({"compare", scene(), "--seeds=" + number}, {"--seeds" + found});
  }
  refused({"run", scene(), "--threads", "010"}, {"--threads: found \"010\""});
  refused({"run", scene(), "--threads", "1.5"}, {"--threads: found \"1.5\""});
  refused({"tradeoff", scene(), "--target", "filled_mass=nan"}, {"--target: found \"filled_mass=nan\""});
}

TEST_F(WrongOptions, PicturesOverwriteNoInput) {
  const std::string text = contents(die_.scene()), cad = contents(die_.folder() / "die.stl");
  fs::create_hard_link(die_.scene(), die_.folder() / "scene.png");
  fs::create_symlink("die.stl", die_.folder() / "die.png");
  fs::create_directory(die_.folder() / "folder.png");
  refused({"check", scene(), "--picture", scene()}, {"--picture: found", "a file that ends in .png"});
  refused({"check", scene(), "--picture", "die.stl"}, {"a file that ends in .png"});
  refused({"check", scene(), "--picture", "picture"}, {"a file that ends in .png"});
  refused({"check", scene(), "--picture", "scene.png"}, {"which the command reads"});
  refused({"check", scene(), "--picture", "die.png"}, {"which the command reads"});
  refused({"check", scene(), "--picture", "folder.png"}, {"which is a directory"});
  refused({"check", scene(), "--picture", "die.stl/a.png"}, {"is a file, not a directory"});
  EXPECT_EQ(contents(die_.scene()), text);
  EXPECT_EQ(contents(die_.folder() / "die.stl"), cad);
  const Outcome made = run_program({"check", scene(), "--picture", "new/FOUND.PNG"}, {die_.folder(), {}});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(contents(die_.folder() / "new" / "FOUND.PNG").substr(1, 3), "PNG");
}

// Nothing can be made in /proc, whatever its permissions say.
TEST_F(WrongOptions, UnwritableFoldersAreNoticedBeforeTheWork) {
  die_.write("die.stl", "no tool");  // which would be the next to be told
  const Outcome outcome = run_program({"check", scene(), "--picture", "/proc/findings.png"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("cannot write to /proc: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("with --picture"), std::string::npos) << outcome.err;
}

TEST_F(WrongOptions, LongNamesAreShortenedInTheirMiddle) {
  const std::string name = std::string(2500, 'a') + std::string(2500, 'b');
  for (const Words& arguments :
       {Words{"run", name + ".toml"}, Words{"check", scene(), "--picture", name + ".png"}, Words{"map", name},
        Words{"run", scene(), "--out", name + "/out"}, Words{"map", "out", "--measured", name + ".csv"},
        Words{name}, Words{"run", scene(), "--" + name}}) {
    const Outcome outcome = run_program(arguments, {die_.folder(), {}});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_LT(outcome.err.size(), 1600U) << outcome.err;
    EXPECT_NE(outcome.err.find("aaa...bbb"), std::string::npos) << outcome.err;
  }
}

TEST_F(WrongOptions, DirectoriesAreNoFiles) {
  die_.write("file", "mine");
  const std::string reason = "is a file, not a directory; choose another directory with ";
  for (const std::string place : {"file", "file/below", "file/"})  // one check for every option
    refused({"run", scene(), "--out", place}, {reason + "--out"});
  for (const std::string place : {"file", "file/below"}) {
    refused({"run", scene(), "--beginnings", place}, {reason + "--beginnings"});
    refused({"compare", scene(), "--out", place}, {reason + "--out"});
    refused({"compare", scene(), "--export-jobs", place}, {reason + "--export-jobs"});
    refused({"tradeoff", scene(), "--vary", "time_step=0.3,0.4", "--out", place}, {reason + "--out"});
    refused({"lab", "stability", "rotation", "--quick", "--out", place}, {reason + "--out"});
    refused({"bench", "spheres", "--trace", place}, {reason + "--trace"});
    refused({"fit-discharge", "a.csv", "--out", place}, {reason + "--out"});
  }
  refused({"new", "file/die"}, {reason});
  EXPECT_EQ(contents(die_.folder() / "file"), "mine");
}

TEST_F(WrongOptions, OtherJsonFilesAreRefusedInOneLine) {
  for (const char* text :
       {"", "no JSON", "[]", "5", "{}", "{\"runs\":[1]}", "{\"runs\":[{\"folder\":5}]}", "{\"runs\":5}",
        "{\"runs\":[{\"folder\":\"a\",\"variant\":[]}]}", "{\"runs\":null}"}) {
    die_.write("comparison.json", text);
    refused({"report", die_.folder().string()}, {"comparison.json: "});
    die_.write("jobs.json", text);
    refused({"compare", "--collect", die_.folder().string()}, {"jobs.json: "});
    die_.write("fit.json", text);
    refused({"estimate", scene(), "--discharge", "fit.json"}, {"fit.json: "});
    for (const char* file : {"comparison.json", "jobs.json", "fit.json"}) fs::remove(die_.folder() / file);
  }
}

TEST_F(WrongOptions, CompareOverwritesNothingThatItReads) {
  const std::string folder = die_.folder().string();
  die_.write("comparison.csv", "azimuth [deg], fill level [mm]\n10, 5\n");
  const std::string expected = "whose comparison.csv the command reads and would overwrite";
  refused({"compare", "--collect", folder, "--measured", "comparison.csv"}, {"--collect: found", expected});
  refused({"compare", scene(), "--out", folder, "--measured", "comparison.csv"}, {"--out: found", expected});
}

TEST_F(WrongOptions, AFolderInPlaceOfAComparisonIsNamed) {
  const std::string folder = die_.folder().string();
  fs::create_directory(die_.folder() / "comparison.json");
  refused({"compare", "--collect", folder}, {"whose comparison.json is a directory"});
  refused({"compare", scene(), "--out", folder}, {"whose comparison.json is a directory"});
  refused({"report", folder}, {"comparison.json: not a comparison written by diefill"});
}

TEST_F(WrongOptions, CollectingTakesNoOptionsOfRuns) {
  const std::string folder = die_.folder().string();
  for (const char* option : {"--seeds", "--jobs", "--out"})
    refused({"compare", "--collect", folder, option, "2"}, {"--collect", option});
}

TEST_F(WrongOptions, CollectingACalibrationTakesNoOptionsOfRuns) {
  const std::string folder = die_.folder().string();
  for (const Words& option : {Words{"--resume"}, Words{"--jobs", "2"}, Words{"--threads", "2"}}) {
    Words call = {"calibrate", "calibration.toml", "--collect", folder};
    call.insert(call.end(), option.begin(), option.end());
    refused(call, {"--collect", option.front()});
  }
}

TEST(New, TakesAFolderWithASlashBehindIt) {
  const support::TemporaryFolder folder;
  for (const std::string name : {"one/", "two//", "a/three/", "four/."}) {
    const Outcome outcome = run_program({"new", name}, {folder.path(), {}});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(folder.path() / name / "fill.toml")) << name;
  }
  EXPECT_EQ(SmallDie::files_in(folder.path()), (Words{"a", "four", "one", "two"}));
}

}  // namespace
}  // namespace diefill::app
