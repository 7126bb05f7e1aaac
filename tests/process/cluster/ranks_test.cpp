// Command lines, scripts and forecasts of runs on ranks.
#include <gtest/gtest.h>

#include <algorithm>

#include "process/cluster/mpi_command.h"
#include "process/cluster/rank_forecast.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::cluster {
namespace {

RankCommand command_on(int ranks) {
  RankCommand command;
  command.program = "/usr/bin/diefill-mpi";
  command.ranks = ranks;
  command.words = {"run", "my die.toml"};
  return command;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TEST(RankCommand, AsksForMoreRanksThanCoresOnlyOnThisMachine) {
  RankCommand command = command_on(8);
  EXPECT_TRUE(has(mpirun_words(command), "--oversubscribe"));
  command.hostfile = "hosts";
  EXPECT_FALSE(has(mpirun_words(command), "--oversubscribe"));
  EXPECT_TRUE(has(mpirun_words(command), "hosts"));
  EXPECT_FALSE(has(mpirun_words(command), "--allow-run-as-root"));
}

TEST(Hosts, WithFewerSlotsThanRanksAreRefused) {
  const support::TemporaryFolder folder;
  folder.write("hosts", "# this machine\nlocalhost slots=2 max_slots=4\n127.0.0.1 slots=1\n");
  EXPECT_NO_THROW(check_hosts(folder.path() / "hosts", 3));
  try {
    check_hosts(folder.path() / "hosts", 4);
    FAIL() << "four ranks have no place";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("3 slots for 4 ranks"), std::string::npos) << error.what();
  }
}

TEST(SlurmScript, QuotesWordsAndResumes) {
  const std::string script = slurm_script(command_on(64));
  EXPECT_NE(script.find("#SBATCH --ntasks=64\n"), std::string::npos);
  EXPECT_NE(script.find("exec srun --mpi=pmix /usr/bin/diefill-mpi run 'my die.toml' --resume\n"),
            std::string::npos)
      << script;
}

TEST(RankStep, OfOneRankIsThatOfItsSpheres) {
  RankCosts costs;
  costs.built_in_step = 2e-8;
  const RankStep step = rank_step(1e5, 7, 1, costs);
  EXPECT_EQ(step.ghosts, 0);
  EXPECT_EQ(step.messages, 0);
  EXPECT_DOUBLE_EQ(step.seconds, 7e5 * costs.slower * costs.built_in_step);
}

TEST(RankStep, GhostsAreTheLayerRoundACube) {
  RankCosts costs;
  costs.built_in_step = 2e-8;
  // 1,000 grains a rank: a cube of 10 in a layer of 1.2.
  const RankStep step = rank_step(64000, 7, 64, costs);
  EXPECT_DOUBLE_EQ(step.own, 1000);
  EXPECT_NEAR(step.ghosts, 12.4 * 12.4 * 12.4 - 1000, 1e-9);
  EXPECT_NEAR(step.bytes, step.ghosts * 104, 1e-6);
  EXPECT_DOUBLE_EQ(step.messages, 26 * 2 * 2 + 2 * 6);
}

TEST(GrainsThatPay, AreThereOnlyWithMoreRanksThanTheyAreSlower) {
  RankCosts costs;
  costs.built_in_step = 2e-8;
  const int few = static_cast<int>(costs.slower);
  EXPECT_EQ(break_even_grains(7, few, 1, costs), 0);
  const double pay = break_even_grains(7, 64, 2, costs);
  ASSERT_GT(pay, 0);
  EXPECT_LT(rank_step(1.2 * pay, 7, 64, costs).seconds, 1.2 * pay * 7 * costs.built_in_step / 2);
}

}  // namespace
}  // namespace diefill::process::cluster
