// Cavities that are too narrow for the grains.
#include <gtest/gtest.h>

#include "process/setup/setup_findings.h"
#include "tests/process/box_tools.h"

namespace diefill::process {
namespace {

/// What is said of cavities of these widths (mm), with grains of 1.8816 mm.
std::vector<SetupFinding> said_of(const std::vector<double>& widths) {
  BoxTools tools(table(), walls_around_the_pour(0.04));
  std::vector<geometry::Cavity> cavities;
  for (const double width : widths) {
    cavities.emplace_back().narrowest_width = 1e-3 * width;
    cavities.back().narrowest_place = {1e-3, 2e-3, -3e-3};
  }
  tools.tooling.cavity = cavities.front();
  tools.tooling.other_cavities.assign(cavities.begin() + 1, cavities.end());
  return cavity_findings(tools.scene, tools.tooling);
}

TEST(CavityFindings, GrainsThatDoNotRunInAreToldWithASizeThatDoes) {
  const auto stuck = said_of({2.4});
  ASSERT_EQ(stuck.size(), 1U);
  for (const char* part :
       {"grains of 1.88 mm do not run to the floor of the cavity, which is 2.4 mm wide at its narrowest, "
        "near (1, 2, "
        "-3) mm",
        "get stuck in widths below 1.4 of their size", "at most a third of the width, 0.8 mm"})
    EXPECT_NE(stuck[0].words.find(part), std::string::npos) << stuck[0].words;
  const auto wider = said_of({1.5});
  ASSERT_EQ(wider.size(), 1U);
  EXPECT_NE(wider[0].words.find("the grains do not fit in"), std::string::npos) << wider[0].words;
}

TEST(CavityFindings, AreForEachCavityThatIsTooNarrow) {
  EXPECT_TRUE(said_of({2.7}).empty());
  EXPECT_TRUE(said_of({0}).empty()) << "not known";
  const auto second = said_of({9, 2});
  ASSERT_EQ(second.size(), 1U);
  EXPECT_NE(second[0].words.find("the floor of cavity 2"), std::string::npos) << second[0].words;
}

}  // namespace
}  // namespace diefill::process
