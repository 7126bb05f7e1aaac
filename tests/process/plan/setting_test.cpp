// What the settings choose, and how that reaches the scene.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/process/plan/plan_sample.h"

namespace diefill::process::plan {
namespace {

constexpr double kCalibrated = 6 * 7.84e-5;  // m, Distaloy AE

TEST(PlanSetting, GrainsAreBoundByTheWidthAndByWhatCoarseGrainingIsProvenFor) {
  PlannedScene planned;
  auto& cavity = planned.tooling.cavity;
  EXPECT_NEAR(numbers_of(Setting::quick, planned.scene, cavity).grain_diameter, 0.42 * 4.5e-3, 1e-12);
  EXPECT_NEAR(numbers_of(Setting::working, planned.scene, cavity).grain_diameter, 1.5e-3, 1e-12);
  EXPECT_NEAR(numbers_of(Setting::reference, planned.scene, cavity).grain_diameter, kCalibrated, 1e-12);
  cavity.narrowest_width = 12e-3;
  EXPECT_NEAR(numbers_of(Setting::quick, planned.scene, cavity).grain_diameter, 8 * kCalibrated, 1e-12);
  EXPECT_NEAR(numbers_of(Setting::working, planned.scene, cavity).grain_diameter, 4 * kCalibrated, 1e-12);
  planned.scene.numerics.period[1] = 4e-3;
  EXPECT_NEAR(numbers_of(Setting::working, planned.scene, cavity).grain_diameter, 1e-3, 1e-12);
}

TEST(PlanSetting, ReferenceTakesThePublishedStepAndTheScenesPowder) {
  const PlannedScene planned;
  const auto reference = numbers_of(Setting::reference, planned.scene, planned.tooling.cavity);
  ASSERT_TRUE(reference.time_step);
  EXPECT_NEAR(*reference.time_step, 2e-6, 1e-15);
  EXPECT_EQ(reference.fill_height, 24e-3);
  const auto working = numbers_of(Setting::working, planned.scene, planned.tooling.cavity);
  EXPECT_FALSE(working.time_step);
  // 5 cm^3 spread over 32 x 29 mm on top of 19 mm is more than the scene has.
  EXPECT_EQ(working.fill_height, 24e-3);
}

TEST(PlanSetting, ReferenceLeavesTheStepToTheProgramWhereThePublishedOneIsTooLong) {
  support::SceneTables tables = PlannedScene::waiting();
  tables.powder = R"(model = "B"
sphere_radius = "0.3 mm"
grain_mass = "1e-7 kg"
)";
  tables.numerics += R"([contact]
coarse_graining = "none"
normal = { law = "linear", stiffness = "50000 N/m" }
damping = { law = "linear restitution", restitution = 0.65 }
)";
  const PlannedScene planned(tables);
  const auto reference = numbers_of(Setting::reference, planned.scene, planned.tooling.cavity);
  EXPECT_FALSE(reference.time_step);
  EXPECT_NO_THROW(with_numbers(planned.scene, reference, "setting reference"));
}

// Wall spheres of 0.6 mm at 1.6 radii let spheres of 0.0788 mm pass; those of the calibrated size have 0.0784
// mm.
TEST(PlanSetting, WallSpheresStandCloserWhereTheFinestGrainsWouldPassBetweenThem) {
  PlannedScene planned;
  planned.scene.walls.sphere_radius = 0.6e-3;
  const auto& cavity = planned.tooling.cavity;
  EXPECT_EQ(numbers_of(Setting::reference, planned.scene, cavity).wall_spacing, 1.4);
  EXPECT_EQ(numbers_of(Setting::working, planned.scene, cavity).wall_spacing, 1.6);
}

TEST(PlanSetting, ThereIsNoneForGrainsOfAFile) {
  const PlannedScene planned;
  EXPECT_EQ(why_no_settings(planned.scene), "");
  Plan plan = sample_plan(planned);
  plan.scene.pour.grains_file = "grains.csv";
  EXPECT_EQ(why_no_settings(plan.scene),
            "pour.grains_file gives the grains their sizes, which settings would change");
  plan.choices.clear();
  add_choices(plan);
  EXPECT_EQ(plan.choices.size(), 1U);
  EXPECT_FALSE(finest_within(plan, 1e6));
  EXPECT_THROW(scene_with_setting(plan.scene, Setting::quick), SceneError);
}

TEST(PlanSetting, PowderBeyondNeedIsLeftOut) {
  support::SceneTables tables = PlannedScene::waiting();
  tables.pour = support::exchanged(tables.pour, "24 mm", "41 mm");
  const PlannedScene planned(tables);
  const auto working = numbers_of(Setting::working, planned.scene, planned.tooling.cavity);
  EXPECT_NEAR(working.fill_height, 0.019 + 5e-6 / (0.032 * 0.029), 1e-9);
}

TEST(PlanSetting, WideWallSpacingOnlyWhereHolesStaySmallAgainstTheGrains) {
  PlannedScene planned;
  // Holes of (2.4 sqrt(2) - 2) 0.15 mm = 0.209 mm against spheres of 0.42 4.5 mm / 6 = 0.315 mm.
  EXPECT_EQ(numbers_of(Setting::quick, planned.scene, planned.tooling.cavity).wall_spacing, 2.4);
  planned.tooling.cavity.narrowest_width = 2.9e-3;  // spheres of 0.203 mm
  EXPECT_EQ(numbers_of(Setting::quick, planned.scene, planned.tooling.cavity).wall_spacing, 1.6);
}

TEST(PlanSetting, NumbersAreWrittenIntoTheSceneAndSaid) {
  const PlannedScene planned;
  const auto numbers = numbers_of(Setting::reference, planned.scene, planned.tooling.cavity);
  const Scene scene = with_numbers(planned.scene, numbers, "setting reference");
  EXPECT_NEAR(scene.powder.grain_diameter, kCalibrated, 1e-12);  // "0.47 mm", as the tables print it
  EXPECT_NE(scene.text.find("0.47 mm"), std::string::npos) << scene.text;
  ASSERT_TRUE(scene.numerics.time_step);
  EXPECT_NEAR(*scene.numerics.time_step, 2e-6, 1e-15);
  const auto chosen = chosen_numbers_in(scene.text);
  ASSERT_EQ(chosen.size(), 3U);
  EXPECT_EQ(chosen[0], "setting reference");
  EXPECT_NE(chosen[1].find("powder.grain_diameter"), std::string::npos);
  EXPECT_NE(chosen[1].find("replacing \"1.88 mm\""), std::string::npos) << chosen[1];
  // Reading the text gives the same again.
  EXPECT_EQ(parse_scene(scene.text, scene.file).powder.grain_diameter, scene.powder.grain_diameter);
}

TEST(PlanSetting, ASceneThatLeavesNumbersToASettingIsRead) {
  support::SceneTables tables = PlannedScene::waiting();
  tables.top += "setting = \"working\"\n";
  tables.powder = "preset = \"Distaloy AE\"\n";
  tables.walls = "sphere_radius = \"0.15 mm\"\n";
  tables.pour = support::exchanged(tables.pour, "fill_height = \"24 mm\"\n", "");
  const PlannedScene planned(tables);
  ASSERT_EQ(setting_of(planned.scene), Setting::working);
  const auto numbers = numbers_of(Setting::working, planned.scene, planned.tooling.cavity);
  const Scene scene = with_numbers(planned.scene, numbers, "setting working");
  EXPECT_FALSE(setting_of(scene));
  EXPECT_EQ(scene.text.find("setting = "), std::string::npos);
  EXPECT_NEAR(scene.powder.grain_diameter, 1.5e-3, 0.011e-3);
  EXPECT_LE(scene.powder.grain_diameter, 1.5e-3 * (1 + 1e-9));
  EXPECT_NEAR(scene.pour.fill_height, 0.019 + 5e-6 / (0.032 * 0.029), 1e-4);
}

TEST(PlanSetting, AllPowdersBecomeCoarserByTheSameFactor) {
  support::SceneTables tables = PlannedScene::waiting();
  tables.pour +=
      "\n[[other_powder]]\nname = \"copper\"\nshare = 0.1\npreset = \"Distaloy AE\"\n"
      "grain_diameter = \"1.41 mm\"\n";
  const PlannedScene planned(tables);
  SettingNumbers numbers = numbers_of(Setting::working, planned.scene, planned.tooling.cavity);
  numbers.grain_diameter = 0.94e-3;
  const Scene scene = with_numbers(planned.scene, numbers, "setting working");
  EXPECT_NEAR(scene.powder.grain_diameter, 0.94e-3, 2e-6);
  ASSERT_EQ(scene.other_powders.size(), 1U);
  EXPECT_NEAR(scene.other_powders[0].powder.grain_diameter, 0.705e-3, 3e-6);
  const auto chosen = chosen_numbers_in(scene.text);
  EXPECT_TRUE(std::any_of(chosen.begin(), chosen.end(), [](const std::string& line) {
    return line.find("other_powder.copper.grain_diameter") != std::string::npos;
  })) << scene.text;
}

TEST(PlanSetting, AnUnknownSettingNamesTheNearest) {
  EXPECT_EQ(setting_named("reference"), Setting::reference);
  try {
    setting_named("workin");
    FAIL() << "an unknown setting was taken";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"working\"?"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace diefill::process::plan
