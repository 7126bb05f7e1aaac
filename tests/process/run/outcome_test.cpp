// What a finished run must say of itself.
#include "process/run/outcome.h"

#include <gtest/gtest.h>

#include "process/machine/motions/rotation.h"
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
  Oscillation oscillation;
  oscillation.frequency = 32;
  scene.steps.push_back(
      std::make_shared<Vibration>(std::vector<std::string>{name}, Eigen::Vector3d::UnitX(), oscillation));
  return scene;
}

/// The same with a tool that turns on and on.
Scene turned(const std::string& name) {
  Scene scene = shaken(name);
  scene.steps = {
      std::make_shared<Rotation>(std::vector<std::string>{name}, RotationAxis{}, 1.0, RampTimes{})};
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

TEST(Outcome, OfADieThatTurnsIsNotThatOfShaking) {
  EXPECT_TRUE(outcome_text(turned("die"), filled_by_ratio()).empty());
}

/// A cavity of 1 cm3 with so many grains in it among others, and this share of it solid.
results::FillResult with_grains_in_cavity(std::size_t grains, double solid_fraction) {
  results::FillResult result;
  result.cavity.volume = 1e-6;
  result.solid_fraction.in_cavity.assign(grains, 1);
  result.solid_fraction.in_cavity.insert(result.solid_fraction.in_cavity.end(), 7, 0);
  result.figures["cavity_solid_fraction"] = solid_fraction;
  // A mean grain much lighter than those that came: their mass does not tell their number.
  result.powder.grain_mass = 1e-6;
  result.figures["filled_mass_kg"] = 1e-5 * static_cast<double>(grains);
  return result;
}

TEST(Outcome, CountsTheGrainsThatLieInTheCavity) {
  const Scene scene = shaken("lower punch");
  auto result = with_grains_in_cavity(38, 0.4);
  const auto lines = outcome_text(scene, result);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("the cavity contains 38 model grains, fewer than 50"), std::string::npos)
      << lines[0];
  EXPECT_TRUE(outcome_text(scene, with_grains_in_cavity(60, 0.4)).empty());
}

TEST(Outcome, OfAnUnknownFillRatioSaysWhatTheShareRestsOn) {
  Scene scene = shaken("lower punch");
  scene.pour.solid_fraction = 0.4;
  auto result = with_grains_in_cavity(60, 0.1);
  auto lines = outcome_text(scene, result);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("roughly 25 % of the powder that would fill it, by the solid fraction of 0.40"),
            std::string::npos)
      << lines[0];
  EXPECT_NE(lines[0].find("the fill ratio itself is unknown"), std::string::npos) << lines[0];
  result.figures["fill_ratio"] = 0.31;
  lines = outcome_text(scene, result);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("contains 31 % of the powder that would fill it"), std::string::npos) << lines[0];
  result.figures["fill_ratio"] = 0.9;
  EXPECT_TRUE(outcome_text(scene, result).empty());
}

}  // namespace
}  // namespace diefill::process
