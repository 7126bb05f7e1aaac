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

}  // namespace
}  // namespace diefill::app
