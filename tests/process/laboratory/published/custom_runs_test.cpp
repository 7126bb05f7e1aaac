// Runs that experiments make themselves: kept whole or not at all, gone on with where they were stopped, not
// made twice.
#include "process/laboratory/published/custom_runs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/numerics/out_of_range.h"
#include "process/results/storage/result_file.h"
#include "process/run/fill_run.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::laboratory {
namespace {

/// Adds up 1 to 100, and is asked to stop after some of them.
struct Counting {
  int steps = 0;       ///< made by all calls together
  int stop_after = 0;  ///< of these; 0: never
  std::atomic<bool> stop = false;

  CustomRun run(const std::string& name = "count", const std::string& settings = "to 100") {
    return {name, settings, 100, [this](std::uint64_t seed, CustomRunWatch& watch) {
              int next = 1, sum = static_cast<int>(seed);
              if (!watch.begun().empty()) std::sscanf(watch.begun().c_str(), "%d %d", &next, &sum);
              for (; next <= 100;) {
                sum += next++;
                ++steps;
                if (steps == stop_after) stop = true;
                watch.report(0.01 * next, [&] { return std::to_string(next) + ' ' + std::to_string(sum); });
              }
              return std::to_string(sum);
            }};
  }
  LabJobs jobs(const std::filesystem::path& folder, int seeds = 1) {
    LabJobs jobs;
    jobs.directory = folder;
    jobs.seeds = seeds;
    jobs.options.show_progress = false;
    jobs.options.stop = &stop;
    return jobs;
  }
};

TEST(CustomRuns, AreKeptAndNotMadeAgain) {
  const support::TemporaryFolder folder;
  Counting counting;
  const CustomRun run = counting.run();
  EXPECT_FALSE(stored_custom_run(folder.path(), run, 1).finished);
  make_custom_runs({run}, counting.jobs(folder.path(), 2));
  EXPECT_EQ(counting.steps, 200);
  EXPECT_EQ(stored_custom_run(folder.path(), run, 1).result, "5051");
  EXPECT_EQ(stored_custom_run(folder.path(), run, 2).result, "5052");
  EXPECT_GT(stored_custom_run(folder.path(), run, 1).core_seconds, 0);
  make_custom_runs({run}, counting.jobs(folder.path(), 3));
  EXPECT_EQ(counting.steps, 300);
}

TEST(CustomRuns, GoOnWhereTheyWereStopped) {
  const support::TemporaryFolder folder;
  Counting counting;
  counting.stop_after = 130;
  const std::vector<CustomRun> runs = {counting.run("first"), counting.run("second"), counting.run("third")};
  EXPECT_THROW(make_custom_runs(runs, counting.jobs(folder.path())), Interrupted);
  EXPECT_TRUE(stored_custom_run(folder.path(), runs[0], 1).finished);
  EXPECT_FALSE(stored_custom_run(folder.path(), runs[1], 1).finished);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "second/seed-1/checkpoint.bin"));
  counting.stop = false;
  make_custom_runs(runs, counting.jobs(folder.path()));
  EXPECT_EQ(counting.steps, 300);
  for (const CustomRun& run : runs)
    EXPECT_EQ(stored_custom_run(folder.path(), run, 1).result, "5051") << run.name;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "second/seed-1/checkpoint.bin"));
}

TEST(CustomRuns, BeginAnewWhereSettingsAreOthersOrFilesDamaged) {
  const support::TemporaryFolder folder;
  Counting counting;
  counting.stop_after = 50;
  EXPECT_THROW(make_custom_runs({counting.run()}, counting.jobs(folder.path())), Interrupted);
  counting.stop = false;
  const CustomRun other = counting.run("count", "to 100, faster");
  make_custom_runs({other}, counting.jobs(folder.path()));
  EXPECT_EQ(counting.steps, 150);
  EXPECT_TRUE(stored_custom_run(folder.path(), other, 1).finished);
  EXPECT_FALSE(stored_custom_run(folder.path(), counting.run(), 1).finished);
  std::ofstream(folder.path() / "count/seed-1/result.json") << "{\"settings\": \"to 100, fa";
  EXPECT_FALSE(stored_custom_run(folder.path(), other, 1).finished);
  std::ofstream(folder.path() / "count/seed-1/checkpoint.bin") << "no checkpoint";
  make_custom_runs({other}, counting.jobs(folder.path()));
  EXPECT_EQ(counting.steps, 250);
}

TEST(CustomRuns, StopWhereTheBudgetIsUsed) {
  const support::TemporaryFolder folder;
  Counting counting;
  LabJobs jobs = counting.jobs(folder.path());
  jobs.options.cpu_seconds = 1e-9;
  const std::vector<CustomRun> runs = {counting.run("first"), counting.run("second")};
  EXPECT_NO_THROW(make_custom_runs(runs, jobs));
  EXPECT_LT(counting.steps, 100);
  for (const CustomRun& run : runs) EXPECT_FALSE(stored_custom_run(folder.path(), run, 1).finished);
}

TEST(CustomRuns, ThatFailAreNotTriedAgainAndStopNoOther) {
  const support::TemporaryFolder folder;
  Counting counting;
  int tries = 0;
  CustomRun failing = counting.run("failing");
  failing.make = [&](std::uint64_t, CustomRunWatch&) -> std::string {
    ++tries;
    throw engine::OutOfRange("grain 7 has no finite position any more");
  };
  const std::vector<CustomRun> runs = {failing, counting.run()};
  for (int call = 0; call < 2; ++call) make_custom_runs(runs, counting.jobs(folder.path()));
  EXPECT_EQ(tries, 1);
  EXPECT_EQ(stored_custom_run(folder.path(), failing, 1).failure, "grain 7 has no finite position any more");
  EXPECT_TRUE(stored_custom_run(folder.path(), runs[1], 1).finished);
}

Counting* asked = nullptr;  // by the experiment below

LabPlan plan_counting(const LabSetting&) {
  LabPlan plan;
  plan.custom_runs = {asked->run("first"), asked->run("second")};
  for (const char* name : {"first", "second"})
    plan.quantities.push_back(
        {.id = std::string("sum of ") + name,
         .quantity = "",
         .unit = "1",
         .runs = {name},
         .value = [name](const SeedResults& seed) { return std::stod(seed.own(name)); }});
  return plan;
}

TEST(CustomRuns, AreCollectedWithoutBeingMade) {
  const support::TemporaryFolder folder;
  Counting counting;
  asked = &counting;
  const SceneExperiment experiment = {"counting", "what is the sum", plan_counting};
  LabJobs jobs = counting.jobs(folder.path());
  make_custom_runs({counting.run("first")}, jobs);
  jobs.run = false;
  const results::LabTable collected = perform(experiment, {}, {}, jobs).table;
  EXPECT_EQ(counting.steps, 100);
  ASSERT_EQ(collected.rows.size(), 2U);
  EXPECT_EQ(collected.rows[0].values, std::vector<double>{5051});
  EXPECT_GT(collected.rows[0].core_seconds, 0);
  EXPECT_EQ(collected.rows[1].verdict, "no value");
  EXPECT_EQ(collected.rows[1].reason, "1 of 1 runs not finished (budget used, or stopped)");
  jobs.run = true;
  EXPECT_EQ(perform(experiment, {}, {}, jobs).table.rows[1].values, std::vector<double>{5051});
  EXPECT_EQ(counting.steps, 200);
}

/// An experiment whose result lacks a column, with a chart of the experiment's own name.
LabPlan plan_lacking(const LabSetting&) {
  LabPlan plan;
  plan.quantities = {
      {.id = "lacking",
       .quantity = "lacking",
       .unit = "1",
       .runs = {},
       .value = [](const SeedResults&) -> double {
         throw results::ResultError("the results have no \"level\"");
       }},
      {.id = "whole", .quantity = "whole", .unit = "1", .runs = {}, .value = [](const SeedResults&) {
         return 2.0;
       }}};
  plan.charts = [](const SeedResults&) {
    results::ExperimentChart chart;
    chart.name = "lacking";
    chart.series = {{.name = "one", .role = results::ExperimentSeries::Role::points, .x = {1}, .y = {2}}};
    return std::vector{chart};
  };
  return plan;
}

TEST(Perform, AResultThatLacksSomethingLeavesTheOtherRows) {
  const support::TemporaryFolder folder;
  LabJobs jobs;
  jobs.directory = folder.path();
  const LabOutcome outcome = perform({"lacking", "what is left", plan_lacking}, {}, {}, jobs);
  ASSERT_EQ(outcome.table.rows.size(), 2U);
  EXPECT_EQ(outcome.table.rows[0].verdict, "no value");
  EXPECT_EQ(outcome.table.rows[0].reason, "the results have no \"level\"");
  EXPECT_EQ(outcome.table.rows[1].values, std::vector<double>{2});
}

TEST(Perform, ChartsDoNotHaveTheNameOfTheTable) {
  const support::TemporaryFolder folder;
  LabJobs jobs;
  jobs.directory = folder.path();
  const LabOutcome outcome = perform({"lacking", "what is left", plan_lacking}, {}, {}, jobs);
  ASSERT_EQ(outcome.charts.size(), 1U);
  EXPECT_EQ(outcome.charts[0].name, "lacking_chart");
}

}  // namespace
}  // namespace diefill::process::laboratory
