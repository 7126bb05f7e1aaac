// diefill run --ranks: the same scene, the same results, on ranks; one line where it cannot be.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Ranks, MissingHostIsNamedWithItsLine) {
  const SmallDie die;
  die.write("hosts", "# one\nno-such-host.invalid slots=2\n");
  const Outcome outcome = die.run({"--ranks", "2", "--hostfile", (die.folder() / "hosts").string()});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("hosts:2: host \"no-such-host.invalid\" is unknown"), std::string::npos)
      << outcome.err;
}

TEST(Ranks, FillTheDieAsThreadsDo) {
  const SmallDie die;
  die.exchange("checkpoint_interval = \"1 s\"", "checkpoint_interval = \"1000 s\"");  // none, however slow
  ASSERT_EQ(die.run({"--no-pictures"}).exit_code, 0);
  const double built_in = die.report()["filled_mass_kg"];
  const Outcome outcome = die.run({"--ranks", "2", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = die.report();
  EXPECT_EQ(report["ranks"], 2);
  // Two grains of 42: the passage is chaotic. Means over eight seeds: PassageOnRanks, a slow test.
  EXPECT_NEAR(report["filled_mass_kg"].get<double>(), built_in, 0.05 * built_in);
  EXPECT_LT(std::abs(report["energy_balance_error"].get<double>()), 0.01);
}

TEST(Ranks, ScriptForSlurmStartsTheSameRun) {
  const SmallDie die;
  const auto script = die.folder() / "job.sh";
  ASSERT_EQ(die.run({"--ranks", "64", "--slurm", script.string()}).exit_code, 0);
  const std::string text = contents(script);
  EXPECT_NE(text.find("#SBATCH --ntasks=64\n"), std::string::npos) << text;
  EXPECT_NE(text.find("diefill-mpi run " + die.scene().string()), std::string::npos) << text;
  EXPECT_NE(text.find("--resume\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace diefill::app
