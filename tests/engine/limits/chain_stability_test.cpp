// How much of a time step's stability wedged grains use up: against closed forms, and against the engine's
// own steps.
#include "engine/limits/chain_stability.h"

#include <gtest/gtest.h>

#include "tests/engine/mixed_support.h"

namespace diefill::engine {
namespace {

constexpr double kStep = 1e-7;  // s, so short that nothing moves in the step that finds the contacts

WallBodySpec floor_at(double height) {
  WallBodySpec floor;
  floor.name = "floor";
  floor.material = "steel";
  floor.planes = {{{0, 0, height}, {0, 0, 1}}};
  return floor;
}

WallBodySpec lid_at(double height) {
  WallBodySpec lid;
  lid.name = "lid";
  lid.material = "steel";
  lid.planes = {{{0, 0, height}, {0, 0, -1}}};
  return lid;
}

/// k dt^2 / 4 + c dt of a contact at `overlap` (m) with this effective radius (m): kg.
double strength(const SimulationSettings& settings, double effective, double overlap) {
  const double root = std::sqrt(effective * overlap), step = settings.time_step;
  return root * (0.25 * settings.grain_contact.reduced_modulus * step * step +
                 settings.grain_contact.damping * step);
}

Simulation with_grain(const SimulationSettings& settings, std::vector<WallBodySpec> walls,
                      const NewGrain& grain) {
  Simulation simulation(settings, std::move(walls));
  simulation.add_grains({grain});
  simulation.step();
  return simulation;
}

TEST(StabilityUsed, OfASphereBetweenTwoPlanesIsThatOfBothContacts) {
  const auto settings = weightless(Model::a, {}, kStep);
  const double radius = settings.shape.sphere_radius, mass = settings.shape.mass;
  NewGrain grain;
  grain.position.z() = 0.8 * radius;
  const auto simulation = with_grain(settings, {floor_at(0), lid_at(1.5 * radius)}, grain);
  const double expected =
      (strength(settings, radius, 0.2 * radius) + strength(settings, radius, 0.3 * radius)) / mass;
  EXPECT_NEAR(stability_used(simulation, {0}).used, expected, 1e-4 * expected);
}

TEST(StabilityUsed, OfASphereOnWallSpheresGoesByTheirRadius) {
  const auto settings = weightless(Model::a, {}, kStep);
  const double radius = settings.shape.sphere_radius, wall_radius = 0.5 * radius;
  WallBodySpec tool;
  tool.centres = {{0, 0, 0}};
  tool.sphere_radius = wall_radius;
  NewGrain grain;
  grain.position.x() = radius + wall_radius - 0.1 * radius;
  const auto simulation = with_grain(settings, {tool}, grain);
  const double expected = strength(settings, radius / 3, 0.1 * radius) / settings.shape.mass;
  EXPECT_NEAR(stability_used(simulation, {0}).used, expected, 1e-4 * expected);
}

TEST(StabilityUsed, CountsThatAForceBesideTheCentreTurnsTheGrainAsWell) {
  const auto settings = weightless(Model::d, {}, kStep);
  const GrainShape& shape = settings.shape;
  const double radius = shape.sphere_radius, tilt = M_PI / 6;
  NewGrain grain;  // its lower arm, 2 R long, leans over by R
  grain.orientation = {std::cos(tilt / 2), 0, std::sin(tilt / 2), 0};
  grain.position.z() = 2 * radius * std::cos(tilt) + 0.7 * radius;
  const auto simulation = with_grain(settings, {floor_at(0)}, grain);
  const double expected =
      strength(settings, radius, 0.3 * radius) * (1 / shape.mass + radius * radius / shape.inertia[1]);
  EXPECT_NEAR(stability_used(simulation, {0}).used, expected, 1e-4 * expected);
}

/// Two spheres at rest on each other between a floor and a lid, pressed together by 0.3 R.
Simulation pressed_pair(const SimulationSettings& settings, double nudge) {
  const double radius = settings.shape.sphere_radius, overlap = 0.3 * radius;
  // The same force at floor and lid, where the effective radius is twice as large.
  const double at_wall = overlap / std::cbrt(2.0), first = radius - at_wall, pitch = 2 * radius - overlap;
  Simulation simulation(settings, {floor_at(0), lid_at(2 * first + pitch)});
  NewGrain lower, upper;
  lower.position.z() = first;
  upper.position.z() = first + pitch + nudge;
  simulation.add_grains({lower, upper});
  simulation.step();
  return simulation;
}

double used_by_pair(double time_step) {
  return stability_used(pressed_pair(weightless(Model::a, {}, time_step), 0), {0, 1}).used;
}

TEST(StabilityUsed, OfTwoSpheresIsThatOfTheirMotionAgainstEachOther) {
  const auto settings = weightless(Model::a, {}, kStep);
  const double radius = settings.shape.sphere_radius;
  const double between = strength(settings, radius / 2, 0.3 * radius),
               at_wall = strength(settings, radius, 0.3 * radius / std::cbrt(2.0));
  const double expected = (at_wall + 2 * between) / settings.shape.mass;
  EXPECT_NEAR(used_by_pair(kStep), expected, 1e-4 * expected);
  // Of one of them alone the other stands fast.
  EXPECT_NEAR(stability_used(pressed_pair(settings, 0), {0}).used, (at_wall + between) / settings.shape.mass,
              1e-4 * expected);
}

TEST(StabilityUsed, IsOneWhereAWedgedPairBeginsToSwingUp) {
  double low = 1e-8, high = 1e-3;  // s
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (used_by_pair(middle) < 1 ? low : high) = middle;
  }
  const auto swing_after = [](double time_step) {
    const auto settings = weightless(Model::a, {}, time_step);
    const double nudge = 1e-6 * settings.shape.sphere_radius;
    auto simulation = pressed_pair(settings, nudge);
    const double rest = pressed_pair(settings, 0).grains().position[1].z();
    double swing = 0;
    for (int step = 0; step < 200; ++step) {
      simulation.step();
      // The last of the swing: what has died away or built up.
      if (step > 190) swing = std::max(swing, std::abs(position_of(simulation, 1).z() - rest) / nudge);
    }
    return swing;
  };
  EXPECT_LT(swing_after(0.97 * low), 1);
  EXPECT_GT(swing_after(1.03 * low), 10);
}

TEST(StabilityUsed, IsTheSameByTheLawPutTogetherWhileTheProgramRuns) {
  const auto settings = weightless(Model::a, {}, kStep);
  const laws::LawParameters law = bierwisch_parts(settings.grain_contact);
  auto general = settings, mixed = settings;
  general.general_contact = GeneralContact{law, law, {}};
  mixed.mix = GrainMix{{{settings.shape, "iron"}}, {{"iron", "iron", law}, {"iron", "steel", law}}, {}};
  const double expected = used_by_pair(kStep);
  EXPECT_NEAR(stability_used(pressed_pair(general, 0), {0, 1}).used, expected, 1e-9 * expected);
  EXPECT_NEAR(stability_used(pressed_pair(mixed, 0), {0, 1}).used, expected, 1e-9 * expected);
}

}  // namespace
}  // namespace diefill::engine
