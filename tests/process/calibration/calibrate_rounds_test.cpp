// Calibrations from start to check, with made-up runs: what they say at their end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "process/calibration/calibrate.h"
#include "process/calibration/screen.h"
#include "process/results/studies/job_cost.h"
#include "process/results/studies/job_list.h"
#include "tests/process/calibration/made_up_runs.h"

namespace diefill::process::calibration {
namespace {

/// The friction f gives 10 f in the slit and 2 f in the die; 0.65 was planted.
class MadeUpRounds : public testing::Test {
 protected:
  MadeUpRounds() {
    made_up_.add("slit", {6.5}, 0.05).simulated = [](const std::vector<FinishedRun>& runs) {
      return std::vector{10 * friction_of(runs.front())};
    };
    made_up_.add("die", {1.3}, 0.05, false).simulated = [](const std::vector<FinishedRun>& runs) {
      return std::vector{2 * friction_of(runs.front())};
    };
    options_.points.directory = made_up_.folder.path() / "jobs";
  }
  /// Round by round, until no runs are left.
  void run_all() {
    for (int round = 0; round < 20; ++round) {
      options_.open_runs = OpenRuns::write;
      if (calibrate(made_up_.plan, options_).open_runs == 0) return;
      for (const auto& job : results::read_job_list(options_.points.directory).jobs)
        make_up_results(options_.points.directory / job.folder);
    }
    FAIL() << "runs are left after 20 rounds";
  }
  results::Calibration collected() {
    options_.open_runs = OpenRuns::leave_out;
    return calibrate(made_up_.plan, options_);
  }

  /// Every file of the directory by its path and contents, but powder.toml, which a fit writes.
  std::map<std::string, std::string> files_but_powder() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(options_.points.directory))
      if (entry.is_regular_file() && entry.path().filename() != "powder.toml")
        found[entry.path().string()] = support::contents(entry.path());
    return found;
  }
  std::string refusal_to_collect() {
    try {
      collected();
    } catch (const SceneError& error) {
      return error.what();
    }
    return "accepted";
  }

  MadeUpCalibration made_up_;
  CalibrateOptions options_;
};

TEST_F(MadeUpRounds, EndWithThePlantedPowderAndItsCheck) {
  run_all();
  const auto account = collected();
  ASSERT_TRUE(account.fitted) << account.stopped;
  EXPECT_NEAR(account.parameters.at(0).best, 0.65, 0.02);
  EXPECT_TRUE(has_line(account.insights, "the check \"die\" is predicted within its deviation"));
  EXPECT_FALSE(has_line(account.remarks, "the check was not run"));
}

TEST_F(MadeUpRounds, TakeSeedsThatNoOtherSetOfParametersHas) {
  made_up_.plan.seeds = 2;
  options_.open_runs = OpenRuns::write;
  calibrate(made_up_.plan, options_);
  std::set<std::uint64_t> seeds;
  const auto jobs = results::read_job_list(options_.points.directory).jobs;
  for (const auto& job : jobs) seeds.insert(job.seed);
  EXPECT_EQ(jobs.size(), 12U);  // six sets of parameters
  EXPECT_EQ(seeds.size(), jobs.size());
}

TEST_F(MadeUpRounds, TakeAsManyPointsAsAreLeftWhereARoundHasMore) {
  made_up_.plan.points_at_once = 20;
  made_up_.plan.most_points = 9;
  // A wave that so few runs do not tell: there is always more to run.
  made_up_.plan.measurements[0].simulated = [](const std::vector<FinishedRun>& runs) {
    return std::vector{10 * friction_of(runs.front()) + 3 * std::sin(60 * friction_of(runs.front()))};
  };
  run_all();
  const auto account = collected();
  EXPECT_EQ(account.stopped, "the search reached its most points (9)");
  EXPECT_EQ(std::count_if(account.points.begin(), account.points.end(),
                          [](const auto& point) { return point.role == "start" || point.role == "search"; }),
            9);
}

TEST_F(MadeUpRounds, CheckOfFourParametersAtSetsEnoughForTheWorthOfAMeasurement) {
  auto& parameters = made_up_.plan.parameters;
  parameters.push_back({"powder.work_of_adhesion", "J/m^2", 0.001, 0.02, false});
  parameters.push_back({"powder.damping_over_radius", "Pa s/m", 3e5, 1.5e6, false});
  parameters.push_back({"walls.friction", "1", 0.1, 0.3, false});
  made_up_.plan.most_points = made_up_.plan.start_points;
  run_all();
  const auto account = collected();
  EXPECT_EQ(std::count_if(account.points.begin(), account.points.end(),
                          [](const auto& point) { return point.role == "edge"; }),
            5);
  EXPECT_FALSE(has_line(account.remarks, "not estimated"));
  EXPECT_EQ(account.worth.size(), 2U);
}

TEST_F(MadeUpRounds, SayWhereTheBudgetLeftNoCheck) {
  run_all();
  options_.points.jobs.cpu_seconds = 0;
  const auto account = collected();
  EXPECT_EQ(account.stopped, "the budget is used");
  EXPECT_TRUE(has_line(account.remarks, "the check was not run: the budget is used"));
  EXPECT_FALSE(has_line(account.insights, "the check \"die\""));
}

TEST_F(MadeUpRounds, AreCollectedWithoutAChangeToTheirScenes) {
  run_all();
  const auto before = files_but_powder();
  ASSERT_TRUE(collected().fitted);
  EXPECT_EQ(files_but_powder(), before);
}

TEST_F(MadeUpRounds, ThoseOfAnotherCalibrationAreRefusedAndStayAsTheyAre) {
  run_all();
  const auto before = files_but_powder();
  made_up_.plan.parameters[0].to = 0.5;
  const std::string said = refusal_to_collect();
  EXPECT_NE(said.find("found no runs of " + made_up_.plan.file.string() + ", but runs of other scenes"),
            std::string::npos)
      << said;
  EXPECT_EQ(files_but_powder(), before);
}

TEST_F(MadeUpRounds, ThoseOfAComparisonAreRefused) {
  std::filesystem::create_directories(options_.points.directory);
  results::write_job_list(options_.points.directory,
                          {"comparison", {"as it is"}, {{"as it is", 1, "as_it_is/seed-1"}}});
  const auto before = files_but_powder();
  EXPECT_NE(refusal_to_collect().find("found no runs of"), std::string::npos);
  EXPECT_EQ(files_but_powder(), before);
}

TEST_F(MadeUpRounds, ARunOfAnotherSceneIsLeftOutWhereTheyAreCollected) {
  run_all();
  const auto other = options_.points.directory / "p002_r01" / "seed-2";
  std::ofstream(other / "scene.toml") << faultless_scene();
  results::add_job_cost(other, {1000, 1000, 1});
  options_.points.jobs.cpu_seconds = 500;
  const auto before = files_but_powder();
  const auto account = collected();
  EXPECT_EQ(account.stopped, "1 runs are not finished: 1 of these folders hold runs of other scenes");
  EXPECT_EQ(account.points.at(1).state, "left out");
  EXPECT_EQ(account.points.at(1).core_seconds, 0);
  EXPECT_FALSE(has_line(account.remarks, "the budget is used"));
  EXPECT_EQ(files_but_powder(), before);
}

TEST_F(MadeUpRounds, NameTheMeasurementWithTooFewValues) {
  made_up_.plan.measurements[0].simulated = [](const std::vector<FinishedRun>&) {
    return std::vector{kNoValue};
  };
  options_.open_runs = OpenRuns::write;
  calibrate(made_up_.plan, options_);
  for (const auto& job : results::read_job_list(options_.points.directory).jobs)
    make_up_results(options_.points.directory / job.folder);
  const auto account = collected();
  EXPECT_FALSE(account.fitted);
  EXPECT_NE(account.stopped.find("too few runs gave values of \"slit\": 0 sets"), std::string::npos)
      << account.stopped;
}

TEST_F(MadeUpRounds, AScreeningNamesACornerThatNoSceneCanHaveBeforeAnythingRuns) {
  made_up_.plan.parameters[0].to = 1000;
  try {
    screen(made_up_.plan, options_);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("measurement \"slit\", run 1 of the screening: powder.friction = 1000"),
              std::string::npos)
        << said;
  }
  EXPECT_FALSE(std::filesystem::exists(options_.points.directory));
}

TEST_F(MadeUpRounds, AScreeningNamesTheRunsWithoutAValueAndKeepsOtherEffects) {
  made_up_.plan.parameters.push_back({"walls.friction", "1", 0.1, 0.3, false});
  made_up_.add("heap", {30}, 1);
  const FractionalDesign design = compact_design(2, 4);
  SimulatedPoints simulated;
  for (std::size_t run = 0; run < design.runs(); ++run) {
    add_point(simulated, "screening", 0,
              {{5.0 + 2 * level(design, run, 0) - 0.5 * level(design, run, 0) * level(design, run, 1)},
               {},
               run == 2 ? std::vector<double>() : std::vector<double>{30}});
    simulated.outcomes.back().reason = run == 2 ? "too soft" : "";
  }
  const results::Screening screening = screening_of(made_up_.plan, design, simulated);
  ASSERT_EQ(screening.quantities.size(), 1U);
  ASSERT_EQ(screening.remarks.size(), 1U);
  EXPECT_EQ(screening.remarks[0], "no effects on heap, which has no value in run 3 (too soft)");
  // y = mean + sum of coefficients times levels of -1 and 1.
  const auto& slit = screening.quantities[0];
  EXPECT_NEAR(slit.mean, 5, 1e-12);
  ASSERT_EQ(slit.regression.size(), 3U);
  for (const auto& term : slit.regression)
    EXPECT_NEAR(term.coefficient,
                term.letters == "A"   ? 2
                : term.letters == "B" ? 0
                                      : -0.5,
                1e-12)
        << term.letters;
}

TEST_F(MadeUpRounds, AScreeningSaysOfEachQuantityWhereItsErrorComesFrom) {
  made_up_.plan.parameters.push_back({"walls.friction", "1", 0.1, 0.3, false});
  made_up_.add("slope", {30}, 1);
  const FractionalDesign design = compact_design(2, 4);
  SimulatedPoints simulated;
  for (std::size_t run = 0; run < design.runs(); ++run) {
    const double friction = level(design, run, 0);
    add_point(simulated, "screening", 0, {{5 + friction}, {}, {2 * friction}});
    simulated.outcomes.back().values[0].push_back({5.1 + friction});  // another seed of the slit alone
  }
  const results::Screening screening = screening_of(made_up_.plan, design, simulated);
  ASSERT_EQ(screening.quantities.size(), 2U);
  EXPECT_EQ(screening.quantities[0].error_source, "runs with other seeds");
  EXPECT_EQ(screening.quantities[1].error_source, "nothing: too few runs; use two seeds or more");
  EXPECT_EQ(screening.error_source,
            "runs with other seeds (slit); nothing: too few runs; use two seeds or more (slope)");
  EXPECT_TRUE(std::isfinite(screening.quantities[0].error_with));
  EXPECT_TRUE(std::isnan(screening.quantities[1].error_with));
  EXPECT_TRUE(has_line(screening.remarks, "no relative error of the regression of slope, which is 0 or"));
}

}  // namespace
}  // namespace diefill::process::calibration
