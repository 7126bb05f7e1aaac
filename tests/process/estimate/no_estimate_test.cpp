// Scenes that formulas say nothing of, and powders beyond those that their laws were compared with.
#include "process/estimate/no_estimate.h"

#include <gtest/gtest.h>

#include "process/estimate/cohesion.h"
#include "process/estimate/statements/limits.h"
#include "process/scene/powder/powder_presets.h"
#include "tests/process/box_tools.h"
#include "tests/process/estimate/estimate_scene.h"

namespace diefill::process::estimate {
namespace {

constexpr double kMm = 1e-3;
constexpr const char* kSquare = "small_dies/square.toml";

/// The estimate of a square cavity under gravity along x, y and z (m/s^2).
Estimate under(const std::string& gravity) {
  return estimated(kSquare, {{"seed = 1", "seed = 1\ngravity = " + gravity}});
}

void expect_none(const Estimate& found, const std::string& because) {
  EXPECT_EQ(found.answer, Answer::no_formula);
  EXPECT_TRUE(found.openings.empty());
  const std::string said = answer_said(found);
  EXPECT_EQ(said.find("no estimate: "), 0U) << said;
  EXPECT_TRUE(says(said, because)) << said;
  EXPECT_TRUE(says(said, "the formulas hold for steady gravity along -z; simulate")) << said;
  ASSERT_EQ(in_short(found).size(), 1U);
  EXPECT_FALSE(says(all_said(found), "full")) << all_said(found);
}

TEST(NoEstimate, UnderGravityThatIsNotAlongMinusZ) {
  expect_none(under(R"(["0 m/s^2", "0 m/s^2", "9.81 m/s^2"])"),
              "gravity (0, 0, 9.81) m/s^2 acts 180 degrees off -z");
  expect_none(under(R"(["9.81 m/s^2", "0 m/s^2", "0 m/s^2"])"), "acts 90 degrees off -z, at most 5");
  expect_none(under(R"(["0 m/s^2", "1.3 m/s^2", "-9.81 m/s^2"])"), "acts 7.55 degrees off -z");
  expect_none(under(R"("0 m/s^2")"), "gravity is 0 m/s^2, less than 0.01");
}

TEST(NoEstimate, IsNotForASlightTiltNorForLessGravity) {
  EXPECT_TRUE(under(R"(["0.8 m/s^2", "0 m/s^2", "-9.81 m/s^2"])").is_estimated());
  EXPECT_TRUE(under(R"("1.62 m/s^2")").is_estimated());
}

TEST(NoEstimate, WhereAStepChangesGravityWhileToolsMove) {
  const std::string change =
      "[[step]]\nkind = \"change\"\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-1.62 m/s^2\"]\n\n";
  expect_none(
      estimated(kSquare, {{"[[step]]", change + "[[step]]"}}),
      "a step changes gravity from (0, 0, -9.81) m/s^2 to (0, 0, -1.62) m/s^2 while tools still move");
  EXPECT_TRUE(estimated(kSquare, {{"[numerics]", change + "[numerics]"}}).is_estimated())
      << "after the passage";
}

TEST(NoEstimate, OfAShoeThatIsClosedBelowSaysThatNothingRunsIn) {
  const Scene scene = sample(kSquare);
  Tooling tooling = read_tooling(scene);
  EXPECT_TRUE(estimate(scene, tooling).is_estimated());
  add_box(tooling.tools[tooling.index_of("shoe")].mesh, {10.5 * kMm, -6.5 * kMm, 0},
          {35.5 * kMm, 6.5 * kMm, 1 * kMm});
  const Estimate found = estimate(scene, tooling);
  EXPECT_EQ(found.answer, Answer::shut);
  EXPECT_TRUE(found.openings.empty());
  EXPECT_EQ(
      answer_said(found).find("nothing runs in: shoe \"shoe\" is closed below all of its powder, z = 1 mm"),
      0U)
      << answer_said(found);
  EXPECT_FALSE(says(all_said(found), "full")) << all_said(found);
  EXPECT_TRUE(found.cycle_time);
}

TEST(Cohesion, BeyondTheRangeOfTheLawLeavesTheAnswerOpen) {
  const auto with_adhesion = [](const std::string& energy) {
    return estimated(kSquare,
                     {{"grain_diameter = ", "work_of_adhesion = \"" + energy + "\"\ngrain_diameter = "}});
  };
  const Estimate usual = with_adhesion("0.005 J/m^2"), sticky = with_adhesion("0.5 J/m^2");
  EXPECT_EQ(too_cohesive(usual), "");
  EXPECT_EQ(sticky.answer, Answer::open);
  const std::string said = answer_said(sticky);
  for (const char* part : {"outside the range of the formula", "Bond number, adhesion over weight, is 123",
                           "compared with flows up to 2.5 (runs of ASC100.29 D2)", "simulate"})
    EXPECT_TRUE(says(said, part)) << said;
}

TEST(Cohesion, OfThePublishedPowdersIsWithinTheRangeOfTheirLaws) {
  for (const std::string& name : preset_names()) {
    Scene scene;
    scene.powder = powder_preset(name);
    EXPECT_LE(bond_number(scene), discharge_of(scene.powder).largest_bond) << name;
  }
}

TEST(Cohesion, OfALawOfItsOwnIsThatOfItsPull) {
  // Johnson, Kendall and Roberts: the pull-off force is 3/2 pi w R_eff, 8/9 of it where the spheres touch.
  const std::string jkr =
      "[contact]\nnormal = { law = \"JKR\", modulus = \"5 MPa\", surface_energy = \"0.0025 J/m^2\" "
      "}\n\n[walls]";
  const double plain = bond_number(sample(kSquare)),
               own = bond_number(sample(kSquare, {{"[walls]", jkr}, {"friction = 0.15\n", ""}}));
  EXPECT_GT(own, 0.6 * plain);
  EXPECT_LT(own, 1.05 * plain);
}

}  // namespace
}  // namespace diefill::process::estimate
