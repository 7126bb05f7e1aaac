// Nothing that was computed is lost: directories are locked, earlier results kept, and runs that are stopped
// by whatever leave what they have.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "process/results/storage/result_file.h"
#include "project_paths.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

void wait_for(Program& program, const fs::path& file) {
  while (program.running() && !fs::exists(file)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

bool any_temporary_file(const fs::path& folder) {
  for (const auto& name : SmallDie::files_in(folder))
    if (name.ends_with(".tmp")) return true;
  return false;
}

/// A die whose run takes about a second.
class Keeping : public testing::Test {
 protected:
  Keeping() { die_.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\""); }
  /// Stopped while the powder falls.
  Outcome stopped_by(int signal) const {
    Program program(die_.run_arguments({"--quiet"}));
    wait_for(program, die_.out());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    program.send(signal);
    return program.wait();
  }
  std::string state() const { return die_.report().at("state_hash"); }

  SmallDie die_;
};

TEST_F(Keeping, ASecondRunIntoADirectoryIsRefusedInOneLineAndTouchesNothing) {
  Program first(die_.run_arguments({"--quiet", "--no-pictures"}));
  wait_for(first, die_.out() / ".diefill-lock");
  const Outcome second = die_.run({"--quiet"});
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_EQ(second.complaints(), 1U) << second.err;
  EXPECT_NE(second.err.find(die_.out().string() + ": locked, another run"), std::string::npos) << second.err;
  const Outcome outcome = first.wait();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_FALSE(fs::exists(die_.out() / ".diefill-lock"));
  EXPECT_FALSE(fs::exists(die_.out() / "previous-1"));
}

TEST_F(Keeping, ARunAnewKeepsTheEarlierResultsAside) {
  ASSERT_EQ(die_.run({"--quiet"}).exit_code, 0);
  const std::string before = contents(die_.out() / "results.h5"), state_before = state();
  const auto files_before = SmallDie::files_in(die_.out());
  die_.write("out/photo.png", "photo");
  die_.exchange("seed = 1", "seed = 2");
  const Outcome outcome = die_.run({"--quiet", "--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("were moved to " + (die_.out() / "previous-1").string()), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(contents(die_.out() / "previous-1/results.h5") == before);
  EXPECT_EQ(SmallDie::files_in(die_.out() / "previous-1"), files_before);
  EXPECT_TRUE(fs::exists(die_.out() / "previous-1/snapshot.png"));
  EXPECT_EQ(contents(die_.out() / "photo.png"), "photo");
  EXPECT_NE(state(), state_before);
}

TEST_F(Keeping, ARunAnewKeepsACheckpointAside) {
  ASSERT_EQ(stopped_by(SIGINT).exit_code, 130);
  const std::string checkpoint = contents(die_.out() / "checkpoint.bin");
  ASSERT_EQ(die_.run({"--quiet", "--no-pictures"}).exit_code, 0);
  EXPECT_TRUE(contents(die_.out() / "previous-1/checkpoint.bin") == checkpoint);
}

TEST_F(Keeping, AFinishedRunSaysSoWhenItIsToGoOn) {
  ASSERT_EQ(die_.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const std::string before = contents(die_.out() / "report.json");
  die_.exchange("Small die, one passage", "Another title");
  const Outcome again = die_.run({"--quiet", "--resume"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.err, "");
  EXPECT_NE(again.out.find("finished (state " + state() + "), nothing was computed"), std::string::npos);
  EXPECT_EQ(contents(die_.out() / "report.json"), before);
  die_.exchange("seed = 1", "seed = 2");
  const Outcome other = die_.run({"--quiet", "--resume"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.complaints(), 1U) << other.err;
  EXPECT_NE(other.err.find("a different scene"), std::string::npos) << other.err;
  EXPECT_EQ(contents(die_.out() / "report.json"), before);
}

TEST_F(Keeping, AFinishedRunOfOtherContentsOfATableIsRefused) {
  die_.exchange("kind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\nvelocity = \"0.2 m/s\"\n",
                "kind = \"table\"\ntool = \"shoe\"\nfile = \"m.csv\"\n");
  die_.write("m.csv", "time s,x mm\n0,0\n0.05,-8\n");
  ASSERT_EQ(die_.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const Outcome again = die_.run({"--quiet", "--resume"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("nothing was computed"), std::string::npos) << again.out;
  die_.write("m.csv", "time s,x mm\n0,0\n0.04,-8\n");
  const Outcome other = die_.run({"--quiet", "--resume"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.complaints(), 1U) << other.err;
  EXPECT_NE(other.err.find("the contents of m.csv have changed"), std::string::npos) << other.err;
}

TEST_F(Keeping, WhereTheTimeIsOverResultsStandAndALargerTimeGoesOn) {
  const SmallDie unbroken;
  unbroken.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  ASSERT_EQ(unbroken.run({"--quiet", "--no-pictures"}).exit_code, 0);
  EXPECT_EQ(unbroken.report().at("finished"), true);
  die_.exchange("[numerics]", "[numerics]\nmax_time = \"30 ms\"");
  using Words = std::vector<std::string>;
  // The second time nothing is left to do.
  for (const Words& more :
       {Words{"--quiet", "--no-pictures"}, Words{"--quiet", "--no-pictures", "--resume"}}) {
    const Outcome over = die_.run(more);
    EXPECT_EQ(over.exit_code, 4);
    EXPECT_EQ(over.complaints(), 1U) << over.err;
    EXPECT_NE(over.err.find("numerics.max_time of 0.03 s"), std::string::npos) << over.err;
    EXPECT_NE(over.err.find("--resume"), std::string::npos) << over.err;
    EXPECT_EQ(die_.report().at("finished"), false);
    EXPECT_NEAR(die_.report().at("simulated_s").get<double>(), 0.03, 1e-4);
    EXPECT_NE(die_.report().at("warnings").at(0).get<std::string>().find("unfinished"), std::string::npos);
    EXPECT_NE(run_program({"info", die_.out().string()}).out.find("UNFINISHED, at t = 0.03"),
              std::string::npos);
  }
  die_.exchange("max_time = \"30 ms\"", "max_time = \"3 s\"");
  die_.exchange("title = \"Small die, one passage\"", "# a comment\ntitle = \"Small die\"");
  const Outcome done = die_.run({"--quiet", "--no-pictures", "--resume"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(state(), unbroken.report().at("state_hash"));
  EXPECT_EQ(die_.report().at("finished"), true);
  EXPECT_FALSE(fs::exists(die_.out() / "checkpoint.bin"));
}

TEST_F(Keeping, EverySignalToStopLeavesACheckpoint) {
  for (const int signal : {SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) {
    const Outcome outcome = stopped_by(signal);
    EXPECT_EQ(outcome.exit_code, 130) << signal << ": " << outcome.err;
    EXPECT_TRUE(fs::exists(die_.out() / "checkpoint.bin")) << signal;
    fs::remove_all(die_.out());
  }
}

TEST_F(Keeping, TemporaryFilesOfAKilledRunGoWithTheNext) {
  Program killed(die_.run_arguments({"--quiet"}));
  wait_for(killed, die_.out() / "checkpoint.bin");
  killed.send(SIGKILL);
  killed.wait();
  die_.write("out/results.h5.999999999-0.tmp", "half");
  ASSERT_EQ(die_.run({"--quiet", "--no-pictures", "--resume"}).exit_code, 0);
  EXPECT_FALSE(any_temporary_file(die_.out()));
}

TEST_F(Keeping, OutputThatDoesNotGetToItsPlaceIsAnError) {
  take_shared_results(die_);
  const std::string said = (die_.folder() / "said").string();
  for (const std::string& words : {"info " + die_.out().string(), std::string("--help")}) {
    const std::string command =
        std::string(DIEFILL_PROGRAM) + ' ' + words + " > /dev/full 2> " + said + "; test $? = 1";
    EXPECT_EQ(std::system(command.c_str()), 0) << words;
    EXPECT_NE(contents(said).find("No space left on device"), std::string::npos) << contents(said);
    EXPECT_EQ(std::string(contents(said)).find('\n'), contents(said).size() - 1) << contents(said);
  }
}

/// Reading takes no lock, so that a program which holds one, such as ParaView, is in nobody's way.
TEST_F(Keeping, LockedResultsCanBeRead) {
  take_shared_results(die_);
  const std::string commands = std::string(DIEFILL_PROGRAM) + " info " + die_.out().string() + " && " +
                               DIEFILL_PROGRAM + " export " + die_.out().string();
  const std::string locked =
      "flock -x " + (die_.out() / "results.h5").string() + " sh -c '" + commands + "' > /dev/null";
  EXPECT_EQ(std::system(locked.c_str()), 0);
}

}  // namespace
}  // namespace diefill::app
