// Pages about work under way, as the program leaves them.
#include <gtest/gtest.h>

#include "tests/app/commands/variants.h"

namespace diefill::app {
namespace {

TEST(Live, ARunLeavesAPageThatSaysHowItEnded) {
  const SmallDie die;
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const std::string page = contents(die.out() / "live.html");
  EXPECT_NE(page.find("class=\"state\">done<"), std::string::npos);
  EXPECT_NE(page.find("width: 100%"), std::string::npos);
  EXPECT_EQ(page.find("http-equiv=\"refresh\""), std::string::npos);
  EXPECT_NE(page.find("powder in the cavity [g]"), std::string::npos);
}

TEST(Live, AComparisonLeavesAPageWithLinksToThoseOfItsRuns) {
  const SmallDie die;
  add_variants(die);
  ASSERT_EQ(run_program(compare_arguments(die, {"--quiet"})).exit_code, 0);
  const std::string page = contents(die.out() / "live.html");
  EXPECT_NE(page.find("2 of 2 runs finished"), std::string::npos);
  EXPECT_NE(page.find("/seed-1/live.html\">stays</a>"), std::string::npos);
}

}  // namespace
}  // namespace diefill::app
