#include "tests/app/random_kills.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {

void expect_same_end(const nlohmann::json& unbroken, const nlohmann::json& broken) {
  for (const char* key :
       {"state_hash", "filled_mass_kg", "steps", "simulated_s", "grains_left", "solid_fraction"})
    EXPECT_EQ(unbroken.at(key), broken.at(key)) << key;
}

void expect_same_end_after_kills(int kills) {
  const SmallDie die, other;
  for (const SmallDie* each : {&die, &other})
    each->exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(Program(other.run_arguments({"--quiet"})).wait().exit_code, 0);
  const auto whole = std::chrono::steady_clock::now() - start;
  std::mt19937 random(20);
  std::uniform_real_distribution<double> share(0.02, 0.8);
  const auto expect_same_results = [&] {
    expect_same_end(other.report(), die.report());
    EXPECT_EQ(results::read_results(die.out()).state_hash, other.report().at("state_hash"));
  };
  for (int done = 0; done < kills;) {
    Program program(die.run_arguments({"--resume", "--quiet"}));
    std::this_thread::sleep_for(share(random) * whole);
    const bool killed = program.running();
    program.send(SIGKILL);
    const Outcome outcome = program.wait();
    if (killed && outcome.signal == SIGKILL) {
      ++done;
      continue;
    }
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_same_results();
    std::filesystem::remove_all(die.out());
  }
  const Outcome last = die.run({"--resume", "--quiet"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_same_results();
}

}  // namespace diefill::app
