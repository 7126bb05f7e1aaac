// Runs that leave the method's valid range stop with a line that says so.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(ValidRange, GrainsThatAreTooSoftStopTheRun) {
  const SmallDie die;
  die.exchange("reduced_modulus = \"3 MPa\"", "reduced_modulus = \"1e4 Pa\"");
  die.exchange("fill_height = \"5 mm\"", "fill_height = \"9 mm\"");
  const Outcome outcome = die.run({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("overlap"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("reduced_modulus"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out() / "results.h5"));
}

TEST(ValidRange, ASceneThatDoesNotEndInTimeStopsTheRun) {
  const SmallDie die;
  die.exchange("[numerics]", "[numerics]\nmax_time = \"5 ms\"");
  const Outcome outcome = die.run({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("numerics.max_time of 0.005"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out() / "results.h5"));
}

TEST(ValidRange, AStepOfTwiceTheMeasuredLimitStopsTheRun) {
  const SmallDie die;
  die.exchange("time_step_fraction = 0.15", "time_step_fraction = 1.0");
  die.exchange("damping_over_radius = \"3e5 Pa s/m\"", "damping_over_radius = \"1e3 Pa s/m\"");
  const Outcome outcome = die.run({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("energy grew"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("STABILITY.md, time step"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out() / "results.h5"));
}

TEST(ValidRange, AWallWithHolesStopsTheRun) {
  const SmallDie die;
  die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.25 mm\"\nspacing = 4.0");
  die.exchange("reduced_modulus = \"3 MPa\"", "reduced_modulus = \"0.1 MPa\"");
  const Outcome outcome = die.run({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("it went through the wall"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(die.out() / "results.h5"));
}

TEST(ValidRange, BetweenComfortableAndForbiddenTheReportSaysSoOnce) {
  const SmallDie die;
  die.exchange("reduced_modulus = \"3 MPa\"", "reduced_modulus = \"0.15 MPa\"");
  const Outcome outcome = die.run({"--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json report = die.report();
  int said = 0;
  for (const auto& warning : report["warnings"])
    said += warning.get<std::string>().find("overlap among grains reached") != std::string::npos ? 1 : 0;
  EXPECT_EQ(said, 1) << report["warnings"].dump();
}

}  // namespace
}  // namespace diefill::app
