// Runs that are stopped or killed: what was reached is kept, and the end is the same.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "tests/app/random_kills.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

void pause_for(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// Waits until `happened` or the program has ended; true if it happened first.
bool wait_until(Program& program, const std::function<bool()>& happened) {
  while (program.running()) {
    if (happened()) return true;
    pause_for(5);
  }
  return false;
}

std::filesystem::path checkpoint(const SmallDie& die) {
  return die.out() / "checkpoint.bin";
}

/// The run's checkpoint, or nothing; it may vanish at any time.
std::string checkpoint_now(const SmallDie& die) {
  try {
    return contents(checkpoint(die));
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// Sends Ctrl-C as soon as the run has begun, that is, while the powder is still falling.
Outcome interrupted_while_falling(const SmallDie& die) {
  Program program(die.run_arguments());
  EXPECT_TRUE(wait_until(program, [&] { return std::filesystem::exists(die.out()); }));
  pause_for(50);
  program.send(SIGINT);
  return program.wait();
}

// Hundreds of thousands of wall spheres take seconds to place.
TEST(Resume, ASetUpThatIsStoppedSaysThatItHasWrittenNothing) {
  const SmallDie die;
  die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.02 mm\"");
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program(die.run_arguments({"--quiet"}));
    pause_for(600);
    ASSERT_TRUE(program.running());
    program.send(signal);
    const Outcome stopped = program.wait();
    EXPECT_EQ(stopped.exit_code, 130);
    EXPECT_EQ(stopped.err, "diefill: stopped during set-up: nothing was written\n");
    EXPECT_FALSE(std::filesystem::exists(die.out()));
  }
}

TEST(Resume, EndsAsTheUnbrokenRunAfterStopsAndKills) {
  const SmallDie die, other;
  // No checkpoint yet: it starts from the beginning, and says so.
  const Outcome unbroken = other.run({"--resume", "--no-pictures"});
  ASSERT_EQ(unbroken.exit_code, 0) << unbroken.err;
  EXPECT_NE(unbroken.err.find("no checkpoint in " + other.out().string() + ": starting from the beginning"),
            std::string::npos)
      << unbroken.err;

  const Outcome stopped = interrupted_while_falling(die);
  EXPECT_EQ(stopped.exit_code, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("diefill: stopped at t = 0."), std::string::npos) << stopped.err;
  EXPECT_NE(stopped.err.find("run the same command with --resume to continue"), std::string::npos);
  EXPECT_EQ(SmallDie::files_in(die.out()), (std::vector<std::string>{"checkpoint.bin", "live.html"}));

  for (const int milliseconds : {0, 80, 300}) {  // killed right after a checkpoint was written, and later
    const std::string before = checkpoint_now(die);
    Program program(die.run_arguments({"--resume", "--no-pictures"}));
    wait_until(program, [&] { return checkpoint_now(die) != before; });
    pause_for(milliseconds);
    program.send(SIGKILL);
    program.wait();
  }
  const Outcome last = die.run({"--resume", "--no-pictures"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_same_end(other.report(), die.report());
  EXPECT_FALSE(std::filesystem::exists(checkpoint(die)));
}

// tests/slow has 25 kills.
TEST(Resume, EndsAsTheUnbrokenRunAfterKillsAtRandomMoments) {
  expect_same_end_after_kills(8);
}

// The stated interval is 1 s; steps of the schedule write checkpoints of their own, and here there are none.
TEST(Checkpoints, AreWrittenAtTheStatedInterval) {
  const SmallDie die;
  die.exchange("kind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\nvelocity = \"0.1 m/s\"",
               "kind = \"wait\"\nduration = \"100 s\"");
  Program program(die.run_arguments({"--quiet"}));
  std::string before;
  for (int written = 0; written < 3; ++written) {
    ASSERT_TRUE(wait_until(program, [&] {
      const std::string now = checkpoint_now(die);
      return !now.empty() && now != before;
    }));
    before = checkpoint_now(die);
  }
  program.send(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
}

TEST(Resume, RefusesADamagedOrForeignCheckpoint) {
  const SmallDie die;
  ASSERT_EQ(interrupted_while_falling(die).exit_code, 130);
  const std::string good = contents(checkpoint(die));
  const auto refusal = [&](const std::string& bytes) {
    die.write("out/checkpoint.bin", bytes);
    const Outcome outcome = die.run({"--resume"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find("checkpoint.bin"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("without --resume"), std::string::npos) << outcome.err;
    EXPECT_EQ(contents(checkpoint(die)), bytes);
    return outcome.err;
  };
  std::string flipped = good;
  flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 4);
  EXPECT_NE(refusal(flipped).find("damaged"), std::string::npos);
  EXPECT_NE(refusal(good.substr(0, good.size() - 1)).find("damaged"), std::string::npos);
  EXPECT_NE(refusal("not a checkpoint at all").find("is not a checkpoint"), std::string::npos);
  refusal("");
  die.exchange("seed = 1", "seed = 2");
  EXPECT_NE(refusal(good).find("belongs to a different scene"), std::string::npos);
}

TEST(Resume, RefusesACheckpointOfOtherCadFiles) {
  const SmallDie die;
  ASSERT_EQ(interrupted_while_falling(die).exit_code, 130);
  die.write("die.stl", cad::binary_stl(cad::block_with_pocket(cad::rectangle(-15, 6, -3.5, 3.5),
                                                              cad::rectangle(-5, -1, -2, 2), -5, -3.9, 0)));
  const Outcome outcome = die.run({"--resume"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("different CAD files"), std::string::npos) << outcome.err;
}

constexpr const char* kTable = "time s,x mm\n0,0\n0.05,-8\n";

/// Begins a run whose shoe follows the table m.csv, edits that once the run has read it, and stops the run.
void edit_the_table_and_stop(const SmallDie& die) {
  die.exchange_passage("[[step]]\nkind = \"table\"\ntool = \"shoe\"\nfile = \"m.csv\"\n");
  die.write("m.csv", kTable);
  Program program(die.run_arguments());
  ASSERT_TRUE(wait_until(program, [&] { return std::filesystem::exists(die.out() / "checkpoint.inputs"); }));
  die.write("m.csv", "time s,x mm\n0,0\n0.04,-8\n");
  pause_for(50);
  program.send(SIGINT);
  ASSERT_EQ(program.wait().exit_code, 130);
}

TEST(Resume, GoesOnWhereAnInputThatWasEditedMeanwhileIsRestored) {
  const SmallDie die;
  ASSERT_NO_FATAL_FAILURE(edit_the_table_and_stop(die));
  die.write("m.csv", kTable);
  const Outcome resumed = die.run({"--resume", "--no-pictures"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("resuming at t = "), std::string::npos) << resumed.err;
}

TEST(Resume, RefusesInputsThatWereEditedWhileTheRunWasGoing) {
  const SmallDie die;
  ASSERT_NO_FATAL_FAILURE(edit_the_table_and_stop(die));
  const Outcome refused = die.run({"--resume"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.complaints(), 1U) << refused.err;
  for (const char* part : {"checkpoint.bin", "different scene: the contents of m.csv have changed"})
    EXPECT_NE(refused.err.find(part), std::string::npos) << refused.err;
  // Begun anew it reads the table as it is; at the end there is nothing to resume.
  ASSERT_EQ(die.run({"--no-pictures", "--quiet"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(die.out() / "previous-1/checkpoint.inputs"));
  EXPECT_FALSE(std::filesystem::exists(die.out() / "checkpoint.inputs"));
  EXPECT_EQ(die.run({"--resume", "--quiet"}).exit_code, 0);
}

}  // namespace
}  // namespace diefill::app
