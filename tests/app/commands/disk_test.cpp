// What a full disk and a bad directory do to a run.
#include <gtest/gtest.h>

#include <cstdlib>

#include "project_paths.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(FullDisk, KeepsEarlierResultsAndLetsTheRunBeFinishedLater) {
  constexpr std::size_t kRoom = 150000;  // bytes: enough for a checkpoint, not for the results
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  ASSERT_EQ(die.run({"--quiet"}).exit_code, 0);
  const std::string state_before = die.report().at("state_hash");
  const auto files = SmallDie::files_in(die.out());
  std::vector<std::string> before;
  for (const auto& file : files) before.push_back(contents(die.out() / file));

  die.exchange("seed = 1", "seed = 2");
  ASSERT_GT(std::filesystem::file_size(die.out() / "results.h5"), kRoom);
  const Outcome outcome = run_program(die.run_arguments({"--quiet"}), {die.folder(), kRoom});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.complaints(), 2U) << outcome.err;  // where the earlier results are, and the error
  EXPECT_NE(outcome.err.find("cannot write " + (die.out() / "results.h5").string()), std::string::npos)
      << outcome.err;
  const auto kept = die.out() / "previous-1";
  for (std::size_t k = 0; k < files.size(); ++k)
    EXPECT_TRUE(contents(kept / files[k]) == before[k]) << files[k];
  EXPECT_EQ(run_program({"info", kept.string()}).exit_code, 0);
  // Only checkpoint and live page are new, and nothing is left half written.
  EXPECT_EQ(SmallDie::files_in(die.out()),
            (std::vector<std::string>{"checkpoint.bin", "live.html", "previous-1"}));

  // With room again the run is finished from there, and another seed has given another packing.
  const Outcome resumed = die.run({"--resume", "--no-pictures"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(die.report().at("state_hash"), state_before);
}

// Where not even a checkpoint can be written the run says so and goes on.
TEST(FullDisk, WithoutRoomForACheckpointWarns) {
  const SmallDie die;
  die.exchange("kind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\nvelocity = \"0.1 m/s\"",
               "kind = \"wait\"\nduration = \"1 ms\"");
  const Outcome outcome = run_program(die.run_arguments(), {die.folder(), 10000});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("warning: no checkpoint written, and there is no earlier one"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("diefill: cannot write "), std::string::npos) << outcome.err;
  EXPECT_EQ(SmallDie::files_in(die.out()), std::vector<std::string>{"live.html"});
}

/// Commands of a shell that run the program where its output does not fit, then where it does. The place is a
/// small file system of its own; where the system lets nobody mount one, files that cannot grow stand in for
/// it.
std::string full_then_enlarged(const SmallDie& die, std::uintmax_t kilobytes) {
  const std::string out = die.out().string(), folder = die.folder().string() + '/';
  const std::string size = std::to_string(kilobytes),
                    mount = "mount -t tmpfs -o size=" + size + "k none " + out;
  const std::string run = std::string(DIEFILL_PROGRAM) + " run " + die.scene().string() + " --out " + out +
                          " --threads 1 --quiet --no-pictures --resume";
  const bool can_mount = std::system(("unshare -rm " + mount + " 2>/dev/null").c_str()) == 0;
  const std::string limit = can_mount ? mount : "trap '' XFSZ; ulimit -f " + std::to_string(2 * kilobytes);
  const std::string enlarge = can_mount ? "mount -o remount,size=64m " + out : ":";
  const std::string commands = "( " + (can_mount ? ":" : limit) + "; " + run + " > " + folder +
                               "said 2>&1; echo $? > " + folder + "code ); ls " + out + " > " + folder +
                               "files; " + enlarge + "; " + run + " > " + folder + "said_then 2>&1; cp " +
                               out + "/report.json " + folder;
  return can_mount ? "unshare -rm sh -c '" + mount + "; " + commands + '\'' : commands;
}

TEST(FullDisk, OfASmallFileSystemLosesNothingAndTheResumedRunEndsAlike) {
  const SmallDie die, other;
  for (const SmallDie* each : {&die, &other})
    each->exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  ASSERT_EQ(other.run({"--quiet", "--no-pictures"}).exit_code, 0);
  std::filesystem::create_directories(die.out());
  const auto results = std::filesystem::file_size(other.out() / "results.h5");
  const int status = std::system(full_then_enlarged(die, results / 1024).c_str());
  EXPECT_EQ(status, 0) << contents(die.folder() / "said_then");
  EXPECT_EQ(contents(die.folder() / "code"), "1\n");
  const std::string said = contents(die.folder() / "said");
  EXPECT_NE(said.find("diefill: cannot write " + (die.out() / "results.h5").string()), std::string::npos)
      << said;
  EXPECT_EQ(contents(die.folder() / "files"), "checkpoint.bin\nlive.html\n");
  const auto report = nlohmann::json::parse(contents(die.folder() / "report.json"));
  for (const char* key : {"state_hash", "steps", "filled_mass_kg", "solid_fraction"})
    EXPECT_EQ(report.at(key), other.report().at(key)) << key;
}

TEST(OutputDirectory, ThatCannotBeMadeStopsTheRunAtOnce) {
  const SmallDie die;
  const auto below_a_file = die.folder() / "scene.toml" / "out";
  const Outcome outcome = run_program({"run", die.scene().string(), "--out", below_a_file.string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("cannot write to " + below_a_file.string()), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--out"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("t = "), std::string::npos) << "it has simulated";
}

}  // namespace
}  // namespace diefill::app
