// What a finished run must say of itself.
#include "process/run/outcome.h"

#include <gtest/gtest.h>

#include "process/machine/motions/vibration.h"

namespace diefill::process {
namespace {

/// A scene of a die and a punch that shakes the tool of this name.
Scene shaken(const std::string& name) {
  Scene scene;
  for (const auto& [tool, role] : {std::pair{"die", ToolRole::die}, {"lower punch", ToolRole::punch}}) {
    scene.tools.emplace_back().name = tool;
    scene.tools.back().role = role;
  }
  scene.steps.push_back(
      std::make_shared<Vibration>(std::vector<std::string>{name}, Eigen::Vector3d::UnitX(), Oscillation{}));
  return scene;
}

results::FillResult filled_by_ratio() {
  results::FillResult result;
  result.figures["fill_ratio"] = 0.8;
  return result;
}

TEST(Outcome, OfAShakenDieTellsThatTheBedOutsideIsPackedToo) {
  const auto lines = outcome_text(shaken("die"), filled_by_ratio());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("filled mass of model powder"), std::string::npos) << lines[0];
}

TEST(Outcome, IsSilentWhereOnlyThePunchIsShakenOrNoFillRatioIsKnown) {
  EXPECT_TRUE(outcome_text(shaken("lower punch"), filled_by_ratio()).empty());
  EXPECT_TRUE(outcome_text(shaken("die"), results::FillResult()).empty());
}

}  // namespace
}  // namespace diefill::process
