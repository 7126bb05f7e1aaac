// diefill run --ranks refuses scenes before any rank starts.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

TEST(Ranks, RefuseWhatTheyCannotBeforeAnyStarts) {
  const SmallDie die;
  die.exchange("[pour]", "[economy]\nsleep = true\n\n[pour]");
  const Outcome outcome = die.run({"--ranks", "2"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("economy.sleep is not supported on ranks"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace diefill::app
