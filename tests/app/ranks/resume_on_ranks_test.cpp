// Runs on ranks that are stopped or killed: one line, nothing written is lost, and they go on with another
// number of ranks.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "tests/app/ranks/running_ranks.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

std::filesystem::path checkpoint(const SmallDie& die) {
  return die.out() / "checkpoint.bin";
}

std::vector<pid_t> ranks_of(const SmallDie& die) {
  return processes_of("diefill-mpi", die.out().string());
}

/// Waits until `happened`, at most a minute; whether it did.
bool wait_until(const std::function<bool()>& happened) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!happened()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Time of the file's last change; of one that is not there the earliest.
std::filesystem::file_time_type changed(const std::filesystem::path& file) {
  std::error_code none;
  return std::filesystem::last_write_time(file, none);
}

/// Runs on `ranks` until a checkpoint has been written again, then does `end` to it.
Outcome broken_off(const SmallDie& die, int ranks, const std::function<void(Program&)>& end) {
  const auto before = changed(checkpoint(die));
  Program program(
      die.run_arguments({"--resume", "--quiet", "--no-pictures", "--ranks", std::to_string(ranks)}));
  EXPECT_TRUE(wait_until([&] { return !program.running() || changed(checkpoint(die)) > before; }));
  end(program);
  return program.wait();
}

/// A shoe so slow that there is time to break the run off.
void slow_down(const SmallDie& die) {
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.02 m/s\"");
}

TEST(ResumeOnRanks, GoesOnWithAnotherNumberOfRanksAndWithout) {
  const SmallDie die;
  slow_down(die);
  for (const int ranks : {2, 4, 1}) {
    const Outcome outcome = broken_off(die, ranks, [](Program& program) { program.send(SIGINT); });
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("diefill: stopped at t = 0."), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_TRUE(ranks_of(die).empty());
  }
  const Outcome last = die.run({"--resume", "--no-pictures"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_GT(die.report()["filled_mass_kg"].get<double>(), 0);
  EXPECT_LT(std::abs(die.report()["energy_balance_error"].get<double>()), 0.01);
}

TEST(ResumeOnRanks, AfterKillsOfARankAndOfMpirunLosesNothingWritten) {
  const SmallDie die;
  slow_down(die);
  const auto kill_all = [](const std::vector<pid_t>& processes) {
    EXPECT_FALSE(processes.empty());
    for (const pid_t process : processes) ::kill(process, SIGKILL);
  };
  const auto expect_one_line = [&](const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find("signal 9"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("--resume"), std::string::npos) << outcome.err;
    EXPECT_TRUE(wait_until([&] { return ranks_of(die).empty(); }));
    EXPECT_TRUE(std::filesystem::exists(checkpoint(die)));
  };
  for (const std::size_t number : {1U, 0U})
    expect_one_line(broken_off(die, 2, [&](Program&) {
      const auto ranks = ranks_of(die);
      ASSERT_EQ(ranks.size(), 2U);
      kill_all({ranks[number]});
    }));
  expect_one_line(
      broken_off(die, 2, [&](Program&) { kill_all(processes_of("mpirun", die.out().string())); }));
  const Outcome last = die.run({"--resume", "--ranks", "2", "--no-pictures"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_NE(last.err.find("resuming at t = 0."), std::string::npos) << last.err;
}

}  // namespace
}  // namespace diefill::app
