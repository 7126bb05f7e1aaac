// Experiments with the method from the command line: tables and charts of each, and names that do not exist.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Lab, AnExperimentLeavesTablesAndCharts) {
  const support::TemporaryFolder folder;
  const auto out = folder.path() / "limits";
  const Outcome outcome = run_program({"lab", "stability", "rotation", "--quick", "--out", out.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(SmallDie::files_in(out),
            (std::vector<std::string>{"rotation.json", "rotation_drift.csv", "rotation_drift.png",
                                      "stability.csv", "stability.json"}));
  const auto limits = nlohmann::json::parse(contents(out / "stability.json"));
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0]["experiment"], "rotation");
  // A hundred turns of a scheme of second order: between a hundredth and a whole radian a step.
  EXPECT_GT(limits[0]["measured"].get<double>(), 0.01);
  EXPECT_LT(limits[0]["measured"].get<double>(), 1);
}

TEST(Lab, WallSpheresAreHeldAgainstTheMesh) {
  const support::TemporaryFolder folder;
  const auto out = folder.path() / "walls";
  const Outcome outcome = run_program({"lab", "walls", "rebound", "--quick", "--out", out.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto limits = nlohmann::json::parse(contents(out / "walls.json"));
  ASSERT_EQ(limits.size(), 8U);
  // Finer wall spheres turn a rebound less.
  EXPECT_GT(limits[6]["measured"].get<double>(), 0);
  EXPECT_GT(limits[6]["measured"].get<double>(), limits[0]["measured"].get<double>());
}

TEST(Lab, AnUnknownExperimentEndsInOneLineWithTheNearest) {
  const Outcome outcome = run_program({"lab", "stability", "rotaton"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("did you mean rotation?"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace diefill::app
