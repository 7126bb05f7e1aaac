// What the experiments on stability stand on: bisection, and the eigenfrequency of a network of contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/contact_network.h"
#include "process/laboratory/stability/elastic_gas.h"
#include "process/laboratory/stability/profile_walls.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/rolling_in_groove.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {
namespace {

TEST(Bisection, FindsTheLimitAndTheEnds) {
  const auto below_two = [](double x) { return x * x < 2; };
  EXPECT_NEAR(largest_that_holds(0.1, 10, 1e-6, below_two), std::sqrt(2), 2e-6);
  EXPECT_DOUBLE_EQ(largest_that_holds(3, 10, 0.1, below_two), 3);
  EXPECT_DOUBLE_EQ(largest_that_holds(0.1, 1, 0.1, below_two), 1);
}

/// A pair of spheres along x with `overlap` (m), or one sphere that deep in the floor.
engine::Simulation still_spheres(const engine::GrainShape& shape, double overlap, bool on_floor,
                                 double tangential = 0) {
  engine::SimulationSettings settings;
  settings.types = {{shape}};
  engine::ContactParameters contact = elastic_contact();
  contact.tangential = tangential;
  contact.friction = tangential > 0 ? 1 : 0;
  settings.contact = bierwisch_contact(contact, contact);
  settings.time_step = 1e-9;
  engine::Simulation simulation(settings, {floor_plate()});
  engine::NewGrain first, second;
  first.position.z() = on_floor ? shape.sphere_radius - overlap : 1e-2;
  second.position = first.position + Eigen::Vector3d(2 * shape.sphere_radius - overlap, 0, 0);
  if (on_floor)
    simulation.add_grains({first});
  else
    simulation.add_grains({first, second});
  return simulation;
}

TEST(ContactNetwork, PairAndFloorOscillateAsSprings) {
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  const double overlap = 1e-6;
  const auto stiffness = [&](double radius) { return 1e7 * std::sqrt(radius * overlap); };
  EXPECT_NEAR(largest_eigenfrequency(still_spheres(sphere, overlap, false)),
              std::sqrt(2 * stiffness(0.5 * sphere.sphere_radius) / sphere.mass), 1e-6 * 1e5);
  EXPECT_NEAR(largest_eigenfrequency(still_spheres(sphere, overlap, true)),
              std::sqrt(stiffness(sphere.sphere_radius) / sphere.mass), 1e-6 * 1e5);
}

TEST(ContactNetwork, TangentialSpringTurnsSpheres) {
  // Two spheres that roll on each other: each gives way by 1 / m + b^2 / I to a force along the surface.
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  const auto rolling = engine::model_b(sphere.sphere_radius, sphere.mass);
  const double overlap = 1e-6, radius = 0.5 * sphere.sphere_radius, kappa = 1e4;
  const double spring = kappa * std::sqrt(overlap / radius), arm = sphere.sphere_radius - 0.5 * overlap;
  const double expected = std::sqrt(2 * spring * (1 / rolling.mass + arm * arm / rolling.inertia.x()));
  EXPECT_NEAR(largest_eigenfrequency(still_spheres(rolling, overlap, false, kappa)), expected,
              1e-6 * expected);
}

TEST(ContactNetwork, NothingTouchesNothingOscillates) {
  EXPECT_EQ(largest_eigenfrequency(still_spheres(thesis_grain(ThesisGrain::sphere), -1e-4, false)), 0);
}

TEST(ElasticGas, KeepsItsEnergyInShortStepsAndLosesAllBoundsInLongOnes) {
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  const auto gas = elastic_gas(sphere, elastic_contact(), 4, 2.5 * sphere.sphere_radius, 0.5);
  const double collision = collision_time(sphere, elastic_contact(), 1.0);
  EXPECT_NEAR(energy_growth(gas, 0.02 * collision, 50 * collision), 0, 1e-3);
  EXPECT_GT(energy_growth(gas, 0.7 * collision, 200 * collision), 0.1);
}

constexpr double kDegree = std::numbers::pi / 180;

TEST(RollingInGroove, ClosedFormIsThatOfAPendulum) {
  // Near the top an inverted pendulum grows by cosh(t / tau); R_L = 20 R: rho = 6.403 R, and it turns.
  const GrooveCase groove{.ratio = 20, .start = 1e-4};
  const double round = kFineRadius * std::sqrt(41.0);
  const double tau = std::sqrt(round * (1 + 0.4 * 441 / 41.0) / 9.81);
  EXPECT_NEAR(rolling_time(groove, 1e-2), tau * std::acosh(100.0), 1e-5 * tau);
  // The equation of motion, step by step, up to an angle that is not small.
  double angle = kDegree, rate = 0, time = 0;
  constexpr double kStep = 1e-6;
  while (angle < 30 * kDegree) {
    rate += 0.5 * kStep * std::sin(angle) / (tau * tau);
    angle += kStep * rate;
    rate += 0.5 * kStep * std::sin(angle) / (tau * tau);
    time += kStep;
  }
  EXPECT_NEAR(rolling_time({.ratio = 20, .start = kDegree}, 30 * kDegree), time, 2e-6);
}

TEST(RollingInGroove, FineSphereRollsAsTheClosedFormSaysAtAllRatios) {
  for (const double ratio : {1.0, 3.0, 20.0, 50.0}) {
    const GrooveCase groove{.ratio = ratio, .start = kDegree};
    const double time = rolling_time(groove, 30 * kDegree);
    EXPECT_NEAR(place_by_engine(groove, time, 1e-6).angle, 30 * kDegree, 0.02 * kDegree) << ratio;
  }
}

TEST(RollingInGroove, FineSphereFallsWhereVelocitiesHalfAStepOldHoldItFast) {
  for (const double ratio : {3.0, 10.0, 20.0, 30.0}) {
    const GrooveCase groove{.ratio = ratio, .start = kDegree};
    const double time = 1.6 * rolling_time(groove, 30 * kDegree);
    const double exact = place_by_engine(groove, time, 2.5e-7).distance;
    EXPECT_GT(exact, 4) << ratio;
    EXPECT_NEAR(place_by_engine(groove, time, 1e-6).distance, exact, 0.01 * exact) << ratio;
    // What the experiment is for: the known error shows in it.
    const double half_steps = place_by_half_steps(groove, time, 1e-6).distance;
    EXPECT_NEAR(half_steps, ratio < 10 ? exact : 1, 0.01 * exact) << ratio;
  }
}

TEST(ProfileWalls, PowderIsOnTheLeftAndTrianglesCoverTheProfile) {
  engine::WallBodySpec trough;
  add_along_y(trough, {{0, 2}, {0, 0}, {3, 0}}, 5);
  ASSERT_EQ(trough.triangles.size(), 4U);
  EXPECT_NEAR((trough.triangles[0].normal() - Eigen::Vector3d::UnitX()).norm(), 0, 1e-15);
  EXPECT_NEAR((trough.triangles[3].normal() - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-15);
  engine::WallBodySpec disc;
  add_about_z(disc, {{0, 0}, {2, 0}});
  double area = 0;
  for (const auto& triangle : disc.triangles) {
    const auto& [a, b, c] = triangle.corner;
    area += 0.5 * (b - a).cross(c - a).norm();
    EXPECT_NEAR((triangle.normal() - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-12);
  }
  EXPECT_NEAR(area, 0.5 * 48 * 4 * std::sin(2 * std::numbers::pi / 48), 1e-12);
}

TEST(StabilityRegistry, NamesAreUniqueAndQuestionsAsked) {
  std::vector<std::string> names;
  for (const auto& experiment : stability_experiments()) {
    EXPECT_EQ(std::count(names.begin(), names.end(), experiment.name), 0) << experiment.name;
    names.push_back(experiment.name);
    EXPECT_TRUE(experiment.question.ends_with("?")) << experiment.question;
  }
}

}  // namespace
}  // namespace diefill::process::laboratory
