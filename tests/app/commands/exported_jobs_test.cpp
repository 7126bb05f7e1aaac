// Comparisons exported as jobs for a queue, and names of variants that files and shells stumble over.
#include <gtest/gtest.h>

#include <cstdlib>

#include "project_paths.h"
#include "tests/app/commands/variants.h"

namespace diefill::app {
namespace {

TEST(ExportedJobs, StandAloneAndGatherToTheSameComparison) {
  const SmallDie die;
  add_variants(die);
  ASSERT_EQ(run_program(compare_arguments(die)).exit_code, 0);
  const auto jobs = die.folder() / "jobs", elsewhere = die.folder() / "elsewhere";
  const Outcome exported = run_program({"compare", die.scene().string(), "--export-jobs", jobs.string()});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_NE(exported.out.find("xargs -d '\\n' -n 1 -P 4 sh -c < jobs.txt"), std::string::npos);
  std::filesystem::rename(jobs, elsewhere);
  for (const char* input : {"die.stl", "shoe.stl", "scene.toml"})
    std::filesystem::remove(die.folder() / input);

  const SmallDie other;
  const Outcome foreign = run_program({"compare", other.scene().string(), "--collect", elsewhere.string()});
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_NE(foreign.err.find("holds runs of another scene"), std::string::npos) << foreign.err;
  const Outcome early = run_program({"compare", "--collect", elsewhere.string()});
  EXPECT_EQ(early.exit_code, 1);
  EXPECT_NE(early.out.find("\"quick\", seed 1: not finished"), std::string::npos) << early.out;
  const std::string shell = "cd " + elsewhere.string() + " && export DIEFILL=" + DIEFILL_PROGRAM + " && ";
  EXPECT_EQ(std::system((shell + "SLURM_ARRAY_TASK_ID=1 SLURM_SUBMIT_DIR=. sh slurm.sh").c_str()), 0);
  const auto first = report_in(elsewhere / "quick/seed-1");
  EXPECT_EQ(std::system((shell + "./run_here.sh 2").c_str()), 0);
  EXPECT_EQ(report_in(elsewhere / "quick/seed-1"), first) << "a finished run was done again";
  const Outcome gathered = run_program({"compare", "--collect", elsewhere.string()});
  EXPECT_EQ(gathered.exit_code, 0) << gathered.err << gathered.out;
  EXPECT_EQ(contents(elsewhere / "comparison.json"), contents(die.out() / "comparison.json"));
}

/// Names that files, shells, tables or earlier versions of the program stumble over.
const std::vector<std::string> kOddNames = {"beginnings", "comparison.json",
                                            "-0.1 m/s, \"fast\"; $(touch oops)"};

/// The small die with variants of odd names, which wait and do nothing else.
void add_odd_variants(const SmallDie& die) {
  std::string text = contents(die.scene());
  int milliseconds = 0;
  for (const auto& name : kOddNames)
    text += "\n[[variant]]\nname = '" + name + "'\n[[variant.step]]\nkind = \"wait\"\nduration = \"" +
            std::to_string(++milliseconds) + " ms\"\n";
  die.write("scene.toml", text);
}

TEST(Compare, TakesVariantsOfAnyNameAndLosesNothingOfThem) {
  const SmallDie die;
  add_odd_variants(die);
  const std::vector<std::string> command = {"compare", die.scene().string(), "--out", die.out().string(),
                                            "--no-pictures"};
  const Outcome outcome = run_program(command);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto comparison = comparison_of(die.out());
  EXPECT_EQ(comparison.at("variants"), kOddNames);
  const std::string table = contents(die.out() / "comparison.csv");
  EXPECT_NE(table.find("\n\"-0.1 m/s, \"\"fast\"\"; $(touch oops)\","), std::string::npos) << table;
  std::vector<nlohmann::json> reports;
  for (const auto& run : comparison.at("runs")) {
    EXPECT_EQ(run.at("state"), "finished");
    reports.push_back(report_in(die.out() / run.at("folder").get<std::string>()));
  }
  EXPECT_FALSE(std::filesystem::exists(die.out() / "beginnings"));

  die.exchange("Small die, one passage", "Another title");
  const Outcome again = run_program(command);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("3 of 3 runs are already done"), std::string::npos) << again.err;
  EXPECT_EQ(again.err.find("kept"), std::string::npos) << again.err;
  EXPECT_EQ(comparison_of(die.out()).at("title"), "Another title");
  std::size_t k = 0;
  for (const auto& run : comparison.at("runs"))
    EXPECT_EQ(report_in(die.out() / run.at("folder").get<std::string>()), reports[k++]);
}

TEST(ExportedJobs, OfAnyNameRunAndAreGathered) {
  const SmallDie die;
  add_odd_variants(die);
  const auto jobs = die.folder() / "jobs with 'blanks'";
  const std::vector<std::string> command = {"compare", die.scene().string(), "--export-jobs", jobs.string()};
  ASSERT_EQ(run_program(command).exit_code, 0);
  const std::string shell =
      std::string("export DIEFILL=") + DIEFILL_PROGRAM + " && \"" + jobs.string() + "/run_here.sh\" 2";
  EXPECT_EQ(std::system(shell.c_str()), 0);
  EXPECT_FALSE(std::filesystem::exists(jobs / "oops"));
  const Outcome gathered = run_program({"compare", "--collect", jobs.string()});
  EXPECT_EQ(gathered.exit_code, 0) << gathered.err << gathered.out;
  const auto before = comparison_of(jobs);
  EXPECT_EQ(before.at("variants"), kOddNames);

  // Jobs of another scene in the same place: what stands there is kept and told of.
  die.exchange("duration = \"1 ms\"", "duration = \"4 ms\"");
  const Outcome other = run_program(command);
  EXPECT_EQ(other.exit_code, 0);
  EXPECT_NE(other.err.find("were renamed: "), std::string::npos) << other.err;
  const std::string folder = before.at("runs").at(0).at("folder");
  EXPECT_TRUE(std::filesystem::exists(jobs / (folder + "-previous-1") / "results.h5"));
  std::filesystem::remove_all(jobs / before.at("runs").at(1).at("folder").get<std::string>());
  const Outcome less = run_program({"compare", "--collect", jobs.string()});
  EXPECT_EQ(less.exit_code, 1);
  EXPECT_NE(less.out.find("\"comparison.json\", seed 1: not finished: its folder"), std::string::npos)
      << less.out;
  EXPECT_NE(less.err.find("were moved to"), std::string::npos) << less.err;
  EXPECT_EQ(comparison_of(jobs / "previous-1"), before);
}

}  // namespace
}  // namespace diefill::app
