// Tables of the laboratory: numbers that are none, and text that CSV would trip over.
#include <gtest/gtest.h>

#include <cmath>

#include "process/results/studies/experiment_result.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

ExperimentResult sample() {
  ExperimentResult result;
  result.name = "sample";
  result.limits = {{"step, \"long\"", 2.5e-6, std::nan(""), "s", ""}};
  ExperimentChart chart;
  chart.name = "curve";
  chart.x.label = "x [m]";
  chart.y.label = "y";
  chart.series = {{.name = "found", .x = {1, 2}, .y = {3, std::nan("")}}};
  result.charts = {chart};
  return result;
}

TEST(ExperimentTables, CurvesOverSeedsHaveTheirStandardDeviation) {
  const support::TemporaryFolder folder;
  ExperimentChart chart = sample().charts[0];
  chart.series[0].y_scatter = {0.5, 0};
  chart.series.push_back(
      {.name = "published", .role = ExperimentSeries::Role::published, .x = {1}, .y = {4}});
  write_chart(folder.path(), chart);
  EXPECT_EQ(support::contents(folder.path() / "curve.csv"),
            "x [m],series,role,y,standard deviation over seeds\n1,found,measured,3,0.5\n"
            "2,found,measured,,0\n1,published,published,4,\n");
}

TEST(ExperimentTables, LimitsAsCsv) {
  const support::TemporaryFolder folder;
  write_limits(folder.path(), "limits", {sample()});
  EXPECT_EQ(support::contents(folder.path() / "limits.csv"),
            "experiment,limit,measured,predicted,unit,source\n"
            "sample,\"step, \"\"long\"\"\",2.5e-06,,s,\n");
}

TEST(ExperimentTables, CurvesAsCsv) {
  const support::TemporaryFolder folder;
  write_experiment(folder.path(), sample());
  EXPECT_EQ(support::contents(folder.path() / "curve.csv"),
            "x [m],series,role,y\n1,found,measured,3\n2,found,measured,\n");
  EXPECT_NE(support::contents(folder.path() / "sample.json").find("null"), std::string::npos);
}

}  // namespace
}  // namespace diefill::results
