// A run that stops and goes on is bit for bit the run that never stopped.
#include <gtest/gtest.h>

#include <set>

#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// A plate that shakes along x.
BodyMotion shaking(double time) {
  BodyMotion motion;
  motion.translation.x() = 1e-4 * std::sin(2000 * time);
  motion.velocity.x() = 0.2 * std::cos(2000 * time);
  return motion;
}

Simulation empty_run(Model model, bool periodic) {
  auto settings = weightless(model, {.friction = 0.5, .work_of_adhesion = 0.01}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 2e-5;
  const double size = 2 * half_size(settings.shape());
  if (periodic) settings.period = {6 * size, 6 * size};
  WallBodySpec floor = plate(4 * size, 1.5e-4, shaking);
  for (auto& centre : floor.centres) centre.z() -= 1.6 * size;
  return {settings, {floor}};
}

Simulation start(Model model, bool periodic) {
  auto simulation = empty_run(model, periodic);
  const double size = 2 * half_size(simulation.settings().shape());
  auto cloud = converging_cloud({5, 5, 3}, size, 0.3, 21);
  for (auto& grain : cloud) grain.velocity.z() -= 0.4;
  simulation.add_grains(cloud);
  return simulation;
}

class Restart : public ::testing::TestWithParam<std::tuple<Model, bool>> {};

TEST_P(Restart, GoesOnBitForBitInAFreshSimulation) {
  const auto [model, periodic] = GetParam();
  auto unbroken = start(model, periodic);
  auto broken = start(model, periodic);
  run_steps(unbroken, 700);
  run_steps(broken, 50);
  // Stop while grains touch each other and the plate.
  Snapshot snapshot = broken.snapshot();
  while (broken.steps() < 600 &&
         (snapshot.grain_history.pair.empty() || snapshot.wall_history.pair.empty())) {
    broken.step();
    snapshot = broken.snapshot();
  }
  ASSERT_LT(broken.steps(), 600U);
  auto resumed = empty_run(model, periodic);
  resumed.restore(snapshot);
  EXPECT_EQ(resumed.hash(), broken.hash());
  EXPECT_EQ(resumed.time(), broken.time());
  EXPECT_EQ(resumed.body_motion(0).translation, broken.body_motion(0).translation);
  EXPECT_EQ(energy_of(resumed).total(), energy_of(broken).total());
  while (resumed.steps() < unbroken.steps()) resumed.step();
  EXPECT_EQ(resumed.hash(), unbroken.hash());
  EXPECT_EQ(resumed.wall_load(0).force, unbroken.wall_load(0).force);
  EXPECT_EQ(resumed.ledger().expected(), unbroken.ledger().expected());
  EXPECT_EQ(resumed.deepest_overlap_of_run(), unbroken.deepest_overlap_of_run());
}

TEST_P(Restart, NewGrainsGetTheSameNamesAndPlaces) {
  const auto [model, periodic] = GetParam();
  auto unbroken = start(model, periodic);
  run_steps(unbroken, 200);
  auto resumed = empty_run(model, periodic);
  resumed.restore(unbroken.snapshot());
  for (Simulation* simulation : {&unbroken, &resumed}) {
    NewGrain extra;
    extra.position = {0, 0, 5e-3};
    extra.velocity = {0, 0, -1};
    simulation->remove_grains([](const Eigen::Vector3d& place) { return place.x() > 5e-4; });
    simulation->add_grains({extra});
    run_steps(*simulation, 200);
  }
  EXPECT_EQ(resumed.hash(), unbroken.hash());
}

/// A fresh start looks at every grain's place; a run that goes on knows for how long none can have gone too
/// far.
TEST_P(Restart, ListsOfNearPairsAreRenewedInTheSameStepsAsIfAllPlacesWereLookedAtInEachOne) {
  const auto [model, periodic] = GetParam();
  auto going = start(model, periodic), looking = start(model, periodic);
  std::set<std::uint64_t> renewals;
  for (int step = 0; step < 400; ++step) {
    looking.restore(looking.snapshot());
    going.step();
    looking.step();
    ASSERT_EQ(going.snapshot().reference.step, looking.snapshot().reference.step) << "step " << step;
    renewals.insert(going.snapshot().reference.step);
  }
  EXPECT_GT(renewals.size(), 3U);
  EXPECT_EQ(going.hash(), looking.hash());
}

INSTANTIATE_TEST_SUITE_P(Powders, Restart,
                         ::testing::Combine(::testing::Values(Model::a, Model::b, Model::c, Model::d),
                                            ::testing::Bool()));

TEST(StateHash, SeesEveryBitOfTheState) {
  auto simulation = start(Model::d, false);
  run_steps(simulation, 10);
  Snapshot snapshot = simulation.snapshot();
  const auto hash = state_hash(snapshot.step, snapshot.grains);
  EXPECT_EQ(hash, simulation.hash());
  snapshot.grains.spin[3].y() = std::nextafter(snapshot.grains.spin[3].y(), 1e9);
  EXPECT_NE(state_hash(snapshot.step, snapshot.grains), hash);
  EXPECT_NE(state_hash(snapshot.step + 1, simulation.grains()), hash);
}

}  // namespace
}  // namespace diefill::engine
