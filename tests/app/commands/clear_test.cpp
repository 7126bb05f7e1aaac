// Steps that remove powder, through the real program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

/// Runs the small die with one more step at its end; gives the heights of the grains that are left, m.
std::vector<double> heights_after(const std::string& step) {
  const std::string velocity = "velocity = \"0.1 m/s\"\n";
  const SmallDie die;
  die.exchange(velocity, velocity + "\n[[step]]\nkind = \"wait\"\nduration = \"10 ms\"\n\n[[step]]\n" + step);
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<double> heights;
  for (const auto& place : results::read_results(die.out()).powder.position) heights.push_back(place[2]);
  const auto report = die.report();
  EXPECT_EQ(report.at("grains").get<double>() + report.at("grains_left").get<double>(), 138);
  return heights;
}

TEST(Clear, CutsTheBedAtAHeight) {
  const auto heights = heights_after("kind = \"clear\"\nabove = \"-2 mm\"\n");
  ASSERT_FALSE(heights.empty());
  // Pressed grains may spring up a little when those above them are gone.
  EXPECT_LT(*std::max_element(heights.begin(), heights.end()), -1.9e-3);
}

TEST(Clear, KeepsTheLowestShare) {
  const auto all = heights_after("kind = \"wait\"\nduration = \"1 ms\"\n");
  EXPECT_EQ(heights_after("kind = \"clear\"\nlowest = 0.5\n").size(), all.size() / 2);
}

TEST(Clear, RefusesTwoWaysAtOnce) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"\n",
               "velocity = \"0.1 m/s\"\n\n[[step]]\nkind = \"clear\"\nabove = \"1 mm\"\nlowest = 0.5\n");
  const Outcome outcome = die.run({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("lowest"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace diefill::app
