// A program that was built without ranks says so.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Ranks, ProgramIsAskedForWhereItIsMissing) {
  const SmallDie die;
  const Outcome outcome = die.run({"--ranks", "2"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("DIEFILL_MPI=ON"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace diefill::app
