// Counts, phases, costs and errors of a plan, compared with numbers by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "process/plan/pilot.h"
#include "process/plan/pilot_scene.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/setup/pour.h"
#include "process/tooling/predicted_memory.h"
#include "tests/process/plan/plan_sample.h"

namespace diefill::process::plan {
namespace {

/// Seven touching spheres of R = d / 6.
double solid_volume(double diameter) {
  return 7 * 4.0 / 3 * std::numbers::pi * std::pow(diameter / 6, 3);
}

TEST(PlanForecast, CountsGrainsFromThePourBox) {
  const PlannedScene planned;
  const auto forecast = plan::forecast(planned.scene, planned.tooling);
  const double grains = 0.032 * 0.029 * 0.024 * 0.32 / solid_volume(planned.scene.powder.grain_diameter);
  EXPECT_NEAR(static_cast<double>(forecast.grains), grains, 1);
  EXPECT_EQ(forecast.spheres, 7 * forecast.grains);
  EXPECT_EQ(forecast.wall_spheres, 300U);
}

TEST(PlanForecast, PhasesAreTheFallTheStepsAndTheRest) {
  const PlannedScene planned;
  RestTimes rest;
  rest.after_fall = 0.1;
  rest.after_motion = 0.2;
  const auto phases = timeline(planned.scene, planned.tooling, rest);
  ASSERT_EQ(phases.size(), 3U);
  const double height = pour_height(planned.scene, engine_settings(planned.scene, 1.0)) - 0.024;
  EXPECT_EQ(phases[0].kind, PhaseKind::fall);
  EXPECT_NEAR(phases[0].seconds, std::sqrt(2 * height / 9.81) + 0.1, 1e-12);
  EXPECT_EQ(phases[1].kind, PhaseKind::rest);  // a wait
  EXPECT_NEAR(phases[1].seconds, 0.3, 1e-12);
  EXPECT_EQ(phases[2].kind, PhaseKind::rest);
  EXPECT_NEAR(phases[2].seconds, 0.2, 1e-12);
}

TEST(PlanForecast, MotionAndPowderTakenAwayAreSeen) {
  support::SceneTables tables;
  tables.steps = R"([[step]]
kind = "move"
tool = "shoe"
direction = "y"
distance = "10 mm"
velocity = "0.1 m/s"
acceleration = "10 m/s^2"
[[step]]
kind = "clear"
[[step]]
kind = "wait"
duration = "0.5 s"
)";
  const PlannedScene planned(tables);
  const auto phases = timeline(planned.scene, planned.tooling, {});
  ASSERT_GE(phases.size(), 3U);
  EXPECT_EQ(phases[1].kind, PhaseKind::motion);
  EXPECT_NEAR(phases[1].seconds, 0.1 + 0.01, 1e-9);
  EXPECT_EQ(phases[1].share, 1);
  const auto poured = static_cast<double>(grains_to_pour(planned.scene));
  const double kept = 5e-6 * 0.32 / solid_volume(planned.scene.powder.grain_diameter);
  EXPECT_EQ(phases[2].kind, PhaseKind::rest);
  EXPECT_NEAR(phases[2].share, kept / poured, 1e-3);
}

TEST(PlanForecast, AShareOfTheGrainsStays) {
  support::SceneTables tables;
  tables.steps =
      "[[step]]\nkind = \"clear\"\nlowest = 0.4\n[[step]]\nkind = \"wait\"\nduration = \"0.5 s\"\n";
  const PlannedScene planned(tables);
  EXPECT_NEAR(timeline(planned.scene, planned.tooling, {}).back().share, 0.4, 1e-9);
}

/// The share of the poured grains that powder which is let in from the start adds half-way, and at the end.
std::pair<double, double> shares_of_inflow(const std::string& keys, std::optional<int> mirror = {}) {
  support::SceneTables tables;
  tables.steps =
      "[[step]]\nkind = \"inflow\"\nfrom = [\"19.4 mm\", \"-14.5 mm\", \"0 mm\"]\nto = [\"51.4 "
      "mm\", \"14.5 mm\", \"110 mm\"]\n" +
      keys;
  PlannedScene planned(tables);
  planned.tooling.mirror = mirror;
  const auto phases = timeline(planned.scene, planned.tooling, {});
  EXPECT_EQ(phases.size(), 3U) << keys;
  EXPECT_EQ(phases[1].kind, PhaseKind::motion);
  const double poured = static_cast<double>(grains_to_pour(planned.scene)) * mean_grain(planned.scene).mass;
  return {(phases[1].share - 1) * poured, (phases[2].share - 1) * poured};
}

TEST(PlanForecast, PowderThatIsLetInGrowsAtItsRate) {
  const auto by_mass = shares_of_inflow("mass = \"60 g\"\nrate = \"20 g/s\"\n");
  EXPECT_NEAR(by_mass.first, 0.03, 1e-9);
  EXPECT_NEAR(by_mass.second, 0.06, 1e-9);
  const auto by_time = shares_of_inflow("rate = \"20 g/s\"\nuntil = { at = \"0.5 s\" }\n");
  EXPECT_NEAR(by_time.first, 0.005, 1e-9);
  EXPECT_NEAR(by_time.second, 0.01, 1e-9);
  const auto as_room_comes_free = shares_of_inflow("mass = \"60 g\"\n");
  EXPECT_NEAR(as_room_comes_free.first, 0.03, 1e-9);
  EXPECT_NEAR(as_room_comes_free.second, 0.06, 1e-9);
  // Poured are the grains of one half, the inflow's mass is that of both.
  EXPECT_NEAR(shares_of_inflow("mass = \"60 g\"\nrate = \"20 g/s\"\n", 1).second, 0.03, 1e-9);
}

TEST(PlanForecast, AFeedLastsItsMassOverItsRate) {
  support::SceneTables tables;
  tables.steps = R"([[step]]
kind = "inflow"
from = ["19.4 mm", "-14.5 mm", "0 mm"]
to = ["51.4 mm", "14.5 mm", "110 mm"]
mass = "33.165 g"
rate = "3.3165 g/s"
)";
  const PlannedScene planned(tables);
  const auto phases = timeline(planned.scene, planned.tooling, {});
  ASSERT_GE(phases.size(), 2U);
  EXPECT_NEAR(phases[1].seconds, 10, 1e-9);
}

TEST(PlanForecast, WallTimeIsCostTimesSphereSteps) {
  const PlannedScene planned;
  const Plan plan = sample_plan(planned);
  const Forecast& forecast = plan.choices[0].forecast;
  const double costs[] = {10e-9, 40e-9, 20e-9};
  double sum = 0;
  for (const auto& part : forecast.phases) {
    const double steps = std::ceil(part.phase.seconds / forecast.time_step);
    EXPECT_EQ(part.steps, steps);
    sum += costs[static_cast<std::size_t>(part.phase.kind)] * steps * static_cast<double>(forecast.spheres);
  }
  ASSERT_TRUE(forecast.wall_seconds);
  EXPECT_NEAR(*forecast.wall_seconds, sum, 1e-9 * sum);
}

TEST(PlanForecast, SearchesComeTheOftenerTheFinerGrainsAreAndTheFasterTheyFall) {
  const PlannedScene planned;
  const Forecast bare = plan::forecast(planned.scene, planned.tooling);
  Pilot pilot;
  for (auto& cost : pilot.cost) cost = {3e-2, 1e6, 0.1, true, 1e-2};
  pilot.fall_time = fall_time(planned.scene, planned.tooling);
  pilot.grain_diameter = bare.grain_diameter;
  pilot.time_step = bare.time_step;
  EXPECT_NEAR(*plan::forecast(planned.scene, planned.tooling, pilot).wall_seconds / bare.sphere_steps(), 3e-8,
              1e-14);
  // Twice the grain in the same step: of three parts, two stay and one is doubled.
  pilot.grain_diameter *= 2;
  EXPECT_NEAR(*plan::forecast(planned.scene, planned.tooling, pilot).wall_seconds / bare.sphere_steps(), 4e-8,
              1e-14);
  // In proportion to the grains, steps do not change how often: a list is a share of a grain wide.
  pilot.time_step *= 2;
  EXPECT_NEAR(*plan::forecast(planned.scene, planned.tooling, pilot).wall_seconds / bare.sphere_steps(), 3e-8,
              1e-14);
  pilot.time_step /= 2;
  // Falling for half as long as well, the pilot's grains became half as fast.
  pilot.fall_time /= 2;
  const Forecast faster = plan::forecast(planned.scene, planned.tooling, pilot);
  EXPECT_NEAR(faster.phases.front().wall_seconds / faster.phases.front().sphere_steps, 6e-8, 1e-14);
}

TEST(PlanForecast, TheShareOfGrainsThatTouchToolsFollowsTheirSizeAndHowHighPowderStands) {
  const PlannedScene planned;
  const Forecast bare = plan::forecast(planned.scene, planned.tooling);
  Pilot pilot;
  for (auto& cost : pilot.cost) cost = {3e-2, 1e6, 0.1, true, 0};
  pilot.size.points = {{1e4, 1e-8, 1e-7}};  // two thirds of the cost are the tools'
  pilot.spheres = 10'000;
  pilot.grain_diameter = bare.grain_diameter;
  pilot.fill_height = planned.scene.pour.fill_height;
  const auto cost = [&] {
    return *plan::forecast(planned.scene, planned.tooling, pilot).wall_seconds / bare.sphere_steps();
  };
  EXPECT_NEAR(cost(), 3e-8, 1e-14);
  pilot.grain_diameter *= 2;
  EXPECT_NEAR(cost(), 2e-8, 1e-14);
  pilot.fill_height /= 3;
  const Eigen::Vector3d sides = planned.scene.pour.upper - planned.scene.pour.lower;
  const double height = planned.scene.pour.fill_height;
  const auto bounds = [&](double h) {
    return (sides.x() * sides.y() + 2 * h * (sides.x() + sides.y())) / (sides.x() * sides.y() * h);
  };
  EXPECT_NEAR(cost(), 1e-8 + 1e-8 * bounds(height) / bounds(height / 3), 1e-14);
}

TEST(PlanForecast, MemoryIsThatOfMeasuredRuns) {
  // Peaks of `diefill run` of shipped scenes: spheres, wall spheres, bytes.
  const double runs[][3] = {{53263, 219043, 598e6}, {27587, 82541, 565e6},  {30436, 154347, 588e6},
                            {2863, 21752, 464e6},   {7532, 37750, 468e6},   {3654, 6488, 442e6},
                            {7609, 35472, 467e6},   {68488, 267375, 605e6}, {220675, 97756, 658e6},
                            {7797, 80396, 562e6},   {3655, 81154, 559e6},   {27587, 82589, 551e6}};
  constexpr double kPromised = 0.1;
  for (const auto& run : runs) EXPECT_NEAR(predicted_memory(run[0], run[1]) / run[2], 1, kPromised);
}

TEST(PlanForecast, ThePilotHasLessPowderOnlyWhereCoarserGrainsDoNotDo) {
  const PlannedScene planned;
  const double sphere_steps = plan::forecast(planned.scene, planned.tooling).sphere_steps();
  const double height = planned.scene.pour.fill_height, diameter = planned.scene.powder.grain_diameter;

  const Scene enough = pilot_scene(planned.scene, planned.tooling, sphere_steps);
  EXPECT_EQ(enough.pour.fill_height, height);
  EXPECT_EQ(enough.powder.grain_diameter, diameter);

  const Scene filling = pilot_scene(planned.scene, planned.tooling, 0.9 * sphere_steps);
  EXPECT_NEAR(filling.pour.fill_height, 0.4 * height, 1e-12);
  EXPECT_EQ(filling.powder.grain_diameter, diameter);

  // What runs out or heaps up does so for as long as there is powder: none is left out.
  Tooling without_cavity = planned.tooling;
  without_cavity.cavity = {};
  const Scene heap = pilot_scene(planned.scene, without_cavity, sphere_steps);
  EXPECT_EQ(heap.powder.grain_diameter, diameter);
  const Scene running_out = pilot_scene(planned.scene, without_cavity, 0.9 * sphere_steps);
  EXPECT_EQ(running_out.pour.fill_height, height);
  EXPECT_GT(running_out.powder.grain_diameter, diameter);
  EXPECT_LE(plan::forecast(running_out, without_cavity).sphere_steps(), 0.45 * sphere_steps);
}

TEST(PlanForecast, AKindThePilotDidNotSeeCostsWhatSettlingDoes) {
  Pilot pilot;
  EXPECT_EQ(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e4), 0);
  pilot.cost[0] = {1, 1e8, 0.1, true};
  pilot.cost[1] = {3, 1e8, 0.1, true};
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::motion, 1e4), 3e-8, 1e-20);
  EXPECT_NEAR(pilot.seconds_per_sphere_step(PhaseKind::rest, 1e4), 1e-8, 1e-20);
}

TEST(PlanForecast, WithinATimeTheFinestGrainsAreTakenThatFit) {
  const PlannedScene planned;
  const Plan plan = sample_plan(planned);
  const double quick = *plan.choices[1].forecast.wall_seconds / 60;
  const double working = *plan.choices[2].forecast.wall_seconds / 60;
  const double time = std::sqrt(quick * working);
  const auto choice = finest_within(plan, time);
  ASSERT_TRUE(choice);
  EXPECT_LE(*choice->forecast.wall_seconds, 60 * time);
  EXPECT_GT(*choice->forecast.wall_seconds, 0.9 * 60 * time);
  EXPECT_LT(choice->forecast.grain_diameter, plan.choices[1].forecast.grain_diameter);
  EXPECT_FALSE(finest_within(plan, 1e-6));
  const auto all_day = finest_within(plan, 1e9);
  ASSERT_TRUE(all_day);
  EXPECT_NEAR(all_day->forecast.grain_diameter, 6 * 7.84e-5, 1e-9);
}

TEST(PlanForecast, TheCheapestChoiceWithinAnErrorIsTakenIfAnyIsKnown) {
  const PlannedScene planned;
  Plan plan = sample_plan(planned);
  for (auto& choice : plan.choices) choice.errors.clear();
  plan.choices[2].errors = {{"solid fraction", 0.04, 0, "test"}, {"mass", 0.02, 0.01, "test"}};
  plan.choices[3].errors = {{"solid fraction", 0.01, 0, "test"}};
  EXPECT_EQ(cheapest_within(plan, 0.05), 2U);
  EXPECT_EQ(cheapest_within(plan, 0.02), 3U);
  EXPECT_FALSE(cheapest_within(plan, 0.005));
  for (auto& choice : plan.choices) choice.errors.clear();
  EXPECT_FALSE(cheapest_within(plan, 0.5));
}

}  // namespace
}  // namespace diefill::process::plan
