// Inputs that once crashed the program or kept it busy for ever, through the real program: one line, exit
// code 2, within seconds.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

void expect_refused(const Outcome& outcome, const std::vector<std::string>& parts) {
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  for (const auto& part : parts) EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

TEST(Endless, StepsThatNeverEndAreRefusedByEveryCommand) {
  const SmallDie die;
  die.exchange("time_step_fraction = 0.15", "time_step_fraction = 1e-300");
  const std::string scene = die.scene().string(), out = die.out().string();
  for (const auto& arguments : std::vector<std::vector<std::string>>{{"check", scene},
                                                                     {"plan", scene},
                                                                     {"run", scene, "--out", out},
                                                                     {"compare", scene, "--out", out},
                                                                     {"tradeoff", scene, "--out", out}}) {
    SCOPED_TRACE(arguments.front());
    expect_refused(run_program(arguments), {"scene.toml: ", " steps, allowed: at most 1e+10"});
    EXPECT_FALSE(std::filesystem::exists(die.out()));
  }
}

TEST(Endless, PowderWithoutWeightNeedsATimeLimit) {
  const SmallDie die;
  die.exchange("[powder]", "gravity = \"0.001 m/s^2\"\n\n[powder]");
  expect_refused(die.check(),
                 {"scene.toml:", "gravity: found ", "may never come to rest", "numerics.max_time"});
  die.exchange("[numerics]", "[numerics]\nmax_time = \"0.5 s\"");
  EXPECT_EQ(die.check().exit_code, 0);
}

TEST(Endless, WallSpheresBeyondCountAreRefusedWithARadiusThatWorks) {
  const SmallDie die;
  die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.001 mm\"");
  Outcome outcome = die.check();
  const auto refusal = outcome.err.find("diefill: ");
  ASSERT_NE(refusal, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("note: walls.sphere_radius is 0.001 mm"), 0U) << outcome.err;
  outcome.err.erase(0, refusal);
  expect_refused(outcome, {"tool \"die\": covering the reachable surface needs about ",
                           " wall spheres of radius 0.001 mm", "use a radius of 0.0"});
}

TEST(Endless, PowderOfTooManyGrainsIsRefused) {
  const SmallDie die;
  die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"0.09 mm\"");
  die.exchange("\"0.5 mm\", \"-2.5 mm\", \"0 mm\"", "\"-500 mm\", \"-500 mm\", \"0 mm\"");
  die.exchange("\"5.5 mm\", \"2.5 mm\", \"9 mm\"", "\"500 mm\", \"500 mm\", \"900 mm\"");
  expect_refused(die.check(), {"grains of 0.09 mm", "GB of memory, but only "});
}

// More grains than check places one by one.
TEST(Endless, PowderOfMillionsOfGrainsIsCounted) {
  const SmallDie die;
  die.exchange("grain_diameter = \"1 mm\"", "grain_diameter = \"0.09 mm\"");
  die.exchange("to = [\"5.5 mm\", \"2.5 mm\", \"9 mm\"]\nfill_height = \"5 mm\"",
               "to = [\"5.5 mm\", \"2.5 mm\", \"60 mm\"]\nfill_height = \"55 mm\"");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(" grains of d = 0.09 mm"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("too many grains to place here, so they are only counted"), std::string::npos)
      << outcome.out;
}

// At 10 kHz and 100 mm a tool throws powder thousands of kilometres high.
TEST(Endless, ToolsShakenAsHardAsAllowedAreChecked) {
  const SmallDie die;
  die.pour_into_the_pocket();
  die.exchange_passage(
      "[[step]]\nkind = \"vibration\"\ntool = \"die\"\naxis = \"y\"\namplitude = \"100 mm\"\nfrequency = "
      "\"10 kHz\"\nduration = \"0.2 s\"\n");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Endless, KeysOfFiftyThousandPartsAreRefused) {
  const SmallDie die;
  std::string key = "a";
  for (int k = 0; k < 50000; ++k) key += ".a";
  die.write("scene.toml", key + " = 1\n");
  expect_refused(die.check(), {"scene.toml:1: found a key of more than 16 parts"});
}

TEST(Endless, PipesAndDevicesAreNoScenes) {
  const SmallDie die;
  const auto pipe = die.folder() / "pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& file : {pipe.string(), std::string("/dev/zero"), die.folder().string()})
    expect_refused(run_program({"check", file}), {": found a "});
}

TEST(Endless, SeedsThatPassTheLargestAreRefusedBeforeAnythingRuns) {
  const SmallDie die;
  die.exchange("seed = 1", "seed = 9223372036854775807");
  for (const std::string command : {"compare", "tradeoff"})
    expect_refused(run_program({command, die.scene().string(), "--seeds", "2", "--out", die.out().string()}),
                   {"seed: found 9223372036854775807, and 2 consecutive seeds exceed 9223372036854775807",
                    "give one from 0 to 9223372036854775806"});
  EXPECT_FALSE(std::filesystem::exists(die.out()));
}

TEST(Endless, WordsOfTheCommandLineAreRefusedOnOneLine) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"check"},
                                             {"bench", "spheres", "--spheres", "1000000000000"},
                                             {"bench", "spheres", "--steps", "-1"},
                                             {"plan", "x.toml", "--minutes", "nan"},
                                             {"fill\x1B[31m\n"},
                                             {"lab", "stability", "no\x1Bsuch"}})
    expect_refused(run_program(arguments), {"diefill: "});
  const Outcome outcome = run_program({"check", "no\x1B[31m such\nfile.toml"});
  expect_refused(outcome, {"no\\u001B[31m such\\nfile.toml"});
}

TEST(Endless, BenchRefusesStepsThatNobodyWaitsFor) {
  expect_refused(run_program({"bench", "spheres", "--spheres", "20000000", "--steps", "100000000"}),
                 {"2e+15 sphere-steps, allowed: at most 1e+15"});
}

}  // namespace
}  // namespace diefill::app
