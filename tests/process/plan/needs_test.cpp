// What a plan reads off tools, powder and steps.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "process/machine/actions/powder_change.h"
#include "process/machine/actions/settle.h"
#include "tests/process/plan/plan_sample.h"

namespace diefill::process::plan {
namespace {

bool says(const std::vector<std::string>& statements, const std::string& words) {
  for (const auto& statement : statements)
    if (statement.find(words) != std::string::npos) return true;
  return false;
}

TEST(PlanNeeds, FacingAreaIsWhatIsSeenFromThere) {
  const auto box = box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_NEAR(facing_area(box, Eigen::Vector3d::UnitX()), 6, 1e-12);
  EXPECT_NEAR(facing_area(box, -Eigen::Vector3d::UnitY()), 3, 1e-12);
  EXPECT_NEAR(facing_area(box, Eigen::Vector3d(1, 1, 0).normalized()), (6 + 3) / std::sqrt(2.0), 1e-12);
}

TEST(PlanNeeds, WidthPressureAndLaws) {
  const PlannedScene planned;
  const Needs needs = needs_of(planned.scene, planned.tooling);
  EXPECT_NEAR(needs.coarsest_grain, 1.5e-3, 1e-12);
  // 4.5 mm less 1.4 times three more calibrated diameters.
  EXPECT_NEAR(needs.effective_width, 4.5e-3 - 1.4 * 3 * 6 * 7.84e-5, 1e-9);
  const double density = 7.63e-8 / (7 * 4.0 / 3 * std::numbers::pi * std::pow(7.84e-5, 3));
  EXPECT_NEAR(needs.weight_pressure, density * 0.32 * 9.81 * (0.024 + 0.02), 1e-3);
  EXPECT_NEAR(needs.least_modulus, 3000 * needs.weight_pressure, 1e-6);
  EXPECT_EQ(needs.piston_pressure, 0);
  EXPECT_EQ(needs.laws.left_out,
            (std::vector<std::string>{"cohesion with tools", "rolling friction", "suction of air"}));
  const auto said = description(needs, planned.scene, planned.tooling);
  EXPECT_TRUE(says(said, "narrowest, 4.500 mm"));
  EXPECT_TRUE(says(said, "0.42 of it"));
  EXPECT_TRUE(says(said, "300 wall spheres"));
  EXPECT_TRUE(says(said, "a half model is possible"));
}

TEST(PlanNeeds, StiffnessIsJudgedByTheLargestGravityOfAnyStep) {
  PlannedScene planned;
  const double at_once = needs_of(planned.scene, planned.tooling).weight_pressure;
  PowderChange fall;
  fall.gravity = Eigen::Vector3d(0, 0, -2 * 9.81);
  planned.scene.gravity.setZero();
  planned.scene.steps.push_back(std::make_shared<Change>(fall));
  const Needs later = needs_of(planned.scene, planned.tooling);
  EXPECT_NEAR(later.weight_pressure, 2 * at_once, 1e-9 * at_once);
  EXPECT_TRUE(says(description(later, planned.scene, planned.tooling), "MPa (3000 times as much)"));
}

TEST(PlanNeeds, StepsThatUntilMayEndEarlierAreSaidToBeForecastAtTheirLongest) {
  PlannedScene planned;
  const Needs needs = needs_of(planned.scene, planned.tooling);
  const std::string words = "simulated time: the longest possible of step.2 (pause), which `until` may end";
  EXPECT_FALSE(says(description(needs, planned.scene, planned.tooling), "simulated time"));
  const auto open = std::make_shared<Settle>(std::nullopt), pause = std::make_shared<Settle>(0.3);
  open->plan.until.emplace().filled_mass = 1e-3;  // lasts until then: it has no length of its own
  pause->plan.name = "pause";
  pause->plan.until.emplace().filled_mass = 1e-3;
  planned.scene.steps = {open, pause};
  EXPECT_TRUE(says(description(needs, planned.scene, planned.tooling), words));
}

TEST(PlanNeeds, WithoutGravityNoLeastStiffnessIsNamed) {
  PlannedScene planned;
  planned.scene.gravity.setZero();
  const Needs needs = needs_of(planned.scene, planned.tooling);
  EXPECT_EQ(needs.least_modulus, 0);
  const auto said = description(needs, planned.scene, planned.tooling);
  EXPECT_TRUE(says(said, "this requires no least E~"));
  EXPECT_FALSE(says(said, " inf ")) << "E~ over nothing";
}

TEST(PlanNeeds, TheStepOfWedgedGrainsIsRemarkedUpon) {
  support::SceneTables tables;
  tables.steps = R"([[step]]
kind = "move"
tool = "shoe"
direction = "y"
distance = "10 mm"
velocity = "0.1 m/s"
)";
  PlannedScene planned(tables);
  const auto remarks = [&] {
    const Needs needs = needs_of(planned.scene, planned.tooling);
    const auto said = description(needs, planned.scene, planned.tooling);
    return std::pair(says(said, "limited by grains wedged by moving tools"),
                     says(said, "up to which grains wedged by moving tools stay stable"));
  };
  // Its own step is that of wedged grains.
  EXPECT_EQ(remarks(), std::pair(true, false));
  const double chosen = needs_of(planned.scene, planned.tooling).time_step;
  planned.scene.numerics.time_step = 0.9 * chosen;
  EXPECT_EQ(remarks(), std::pair(false, false));
  planned.scene.numerics.time_step = 2 * chosen;
  EXPECT_EQ(remarks(), std::pair(false, true));
  planned.scene.steps.clear();  // nothing moves
  EXPECT_EQ(remarks(), std::pair(false, false));
}

TEST(PlanNeeds, APistonPressesOnItsArea) {
  support::SceneTables tables;
  tables.steps = R"([[step]]
kind = "piston"
tool = "shoe"
direction = "-z"
force = "8 N"
speed_limit = "0.1 m/s"
travel = "5 mm"
duration = "0.1 s"
)";
  const PlannedScene planned(tables);
  const Needs needs = needs_of(planned.scene, planned.tooling);
  EXPECT_NEAR(needs.piston_pressure, 8 / (0.1 * 0.04), 1e-9);
}

TEST(PlanNeeds, MotionAcrossThePlaneSpoilsTheSymmetry) {
  support::SceneTables tables;
  tables.steps = R"([[step]]
kind = "vibration"
tool = "shoe"
axis = "y"
amplitude = "0.1 mm"
frequency = "50 Hz"
duration = "0.2 s"
)";
  const PlannedScene across(tables);
  const Needs spoilt = needs_of(across.scene, across.tooling);
  bool found = false;
  for (const auto& plane : spoilt.planes)
    if (plane.normal[1] > 0.5) {
      found = true;
      EXPECT_NE(plane.asymmetry.find("the motion"), std::string::npos);
    }
  EXPECT_TRUE(found);
  tables.steps = support::exchanged(tables.steps, "axis = \"y\"", "axis = \"x\"");
  const PlannedScene along(tables);
  for (const auto& plane : needs_of(along.scene, along.tooling).planes) {
    if (plane.normal[1] > 0.5) {
      EXPECT_EQ(plane.asymmetry, "");
    }
  }
}

/// What breaks the symmetry across y = 0.
std::string asymmetry_across_y(const PlannedScene& planned) {
  for (const auto& plane : needs_of(planned.scene, planned.tooling).planes)
    if (plane.normal[1] > 0.5) return plane.asymmetry;
  ADD_FAILURE() << "the tools have that plane";
  return {};
}

TEST(PlanNeeds, GravityAcrossThePlaneBreaksTheSymmetry) {
  PlannedScene planned;
  planned.scene.gravity = {3, 0, -9};
  EXPECT_EQ(asymmetry_across_y(planned), "");
  planned.scene.gravity = {0, 3, -9};
  EXPECT_EQ(asymmetry_across_y(planned), "gravity");
  const Needs needs = needs_of(planned.scene, planned.tooling);
  EXPECT_TRUE(says(description(needs, planned.scene, planned.tooling),
                   "mirror images across y = 0 mm, but not gravity"));
}

TEST(PlanNeeds, GravityThatAStepTurnsAcrossThePlaneBreaksTheSymmetry) {
  PlannedScene planned;
  PowderChange along, across;
  along.gravity = Eigen::Vector3d(1, 0, -9);
  across.gravity = Eigen::Vector3d(0, -1, -9);
  planned.scene.steps.push_back(std::make_shared<Change>(along));
  EXPECT_EQ(asymmetry_across_y(planned), "");
  planned.scene.steps.push_back(std::make_shared<Change>(across));
  EXPECT_EQ(asymmetry_across_y(planned), "gravity from the step on: change of gravity");
}

}  // namespace
}  // namespace diefill::process::plan
