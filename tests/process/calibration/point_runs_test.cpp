// Values read off the results of a calibration's runs: what a result lacks costs no more than itself.
#include "process/calibration/point_runs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "process/compare/run_jobs.h"
#include "tests/process/calibration/made_up_runs.h"

namespace diefill::process::calibration {
namespace {

/// Two seeds of one point, in its folders.
class RunsOfAPoint : public testing::Test {
 protected:
  RunsOfAPoint() {
    made_up_.plan.seeds = 2;
    options_.directory = made_up_.folder.path() / "runs";
    made_up_.add("level", {4}, 0.1).simulated = [](const std::vector<FinishedRun>& runs) {
      return std::vector{runs.front().result->figures.at("narrowest_mm")};
    };
  }
  std::filesystem::path folder(const std::string& seed, const std::string& point = "p001") const {
    return options_.directory / (point + "_r01") / ("seed-" + seed);
  }
  PointOutcome outcome(std::size_t number = 0) const {
    return PointRuns(made_up_.plan, options_).outcome({"start", {0.5}}, number);
  }

  MadeUpCalibration made_up_;
  PointOptions options_;
};

TEST_F(RunsOfAPoint, AreReadSeedBySeed) {
  make_up_results(folder("1"));
  make_up_results(folder("2"));
  const PointOutcome found = outcome();
  EXPECT_EQ(found.state, "finished");
  EXPECT_TRUE(found.reason.empty()) << found.reason;
  EXPECT_EQ(found.values, (std::vector<std::vector<std::vector<double>>>{{{3.1}, {3.1}}}));
}

TEST_F(RunsOfAPoint, ADamagedResultHasNoValueAndTheReasonStays) {
  for (const char* seed : {"1", "2"}) {
    make_up_results(folder(seed));
    std::ofstream(folder(seed) / "results.h5") << "cut off";
  }
  const PointOutcome found = outcome();
  EXPECT_EQ(found.state, "failed");
  EXPECT_FALSE(found.has(0));
  EXPECT_NE(found.reason.find("its results have no value of \"level\": "), std::string::npos) << found.reason;
  EXPECT_NE(found.reason.find("results.h5"), std::string::npos) << found.reason;
}

TEST_F(RunsOfAPoint, ASeedWithoutTheSnapshotLeavesTheOtherSeed) {
  make_up_results(folder("1"));
  make_up_results(folder("2"));
  made_up_.plan.measurements[0].simulated = [](const std::vector<FinishedRun>& runs) {
    if (runs.front().folder.filename() == "seed-2") throw results::ResultError("no snapshot \"settled\"");
    return std::vector{4.0};
  };
  const PointOutcome found = outcome();
  EXPECT_EQ(found.state, "finished");
  EXPECT_EQ(found.values[0].size(), 1U);
  EXPECT_EQ(found.reason, "a seed has no value of \"level\": no snapshot \"settled\"");
}

TEST_F(RunsOfAPoint, APlaceWithoutAValueLeavesTheOtherPlaces) {
  make_up_results(folder("1"));
  make_up_results(folder("2"));
  made_up_.plan.measurements[0].simulated = [](const std::vector<FinishedRun>& runs) {
    return std::vector{4.0, runs.front().folder.filename() == "seed-1" ? 5.0 : kNoValue};
  };
  const PointOutcome found = outcome();
  EXPECT_EQ(found.state, "finished");
  EXPECT_EQ(found.over_seeds(0, 0).count, 2U);
  EXPECT_EQ(found.over_seeds(0, 1).count, 1U);
  EXPECT_EQ(found.over_seeds(0, 1).mean, 5);
}

TEST_F(RunsOfAPoint, HaveSeedsOfTheirOwn) {
  make_up_results(folder("3", "p002"));
  make_up_results(folder("4", "p002"));
  EXPECT_EQ(outcome(1).values[0].size(), 2U);
  EXPECT_EQ(outcome(0).state, "left out");
}

}  // namespace
}  // namespace diefill::process::calibration
