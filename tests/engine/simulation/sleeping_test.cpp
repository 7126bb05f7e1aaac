// Grains put to sleep: what they save, what they leave as it was, and what wakes them.
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "engine/observe/powder_figures.h"
#include "engine/simulation/sleep_rules.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kStep = 4e-6;  // s

/// Spheres that do not rotate, in a periodic box over a plate.
SimulationSettings bed_settings(bool sleep, int threads = 1) {
  auto settings = weightless(Model::a, {.friction = 0.5}, kStep);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  const double size = 2 * half_size(settings.shape());
  settings.period = {13 * size, 13 * size};
  if (sleep) settings.sleep = SleepSettings{};
  return settings;
}

double grain_size() {
  return 2 * half_size(thesis_shape(Model::a));
}

Simulation empty_box(bool sleep, int threads = 1, std::function<BodyMotion(double)> motion = {}) {
  return {bed_settings(sleep, threads), {plate(9 * grain_size(), 1.5e-4, std::move(motion))}};
}

/// Nine layers of grains, to be poured.
std::vector<NewGrain> poured() {
  return converging_cloud({11, 11, 9}, 1.1 * grain_size(), 0.05, 5, {0, 0, 5.5 * grain_size()});
}

/// The bed 0.14 s later, nearly all of its grains asleep, or none.
const Snapshot& settled(bool sleep) {
  const auto settle = [](bool sleeps) {
    auto simulation = empty_box(sleeps);
    simulation.add_grains(poured());
    run_steps(simulation, 35000);
    return simulation.snapshot();
  };
  static const Snapshot asleep = settle(true), awake = settle(false);
  return sleep ? asleep : awake;
}

Simulation sleeping_bed(int threads = 1, std::function<BodyMotion(double)> motion = {}) {
  auto simulation = empty_box(true, threads, std::move(motion));
  simulation.restore(settled(true));
  return simulation;
}

/// A few grains that fall onto one corner of the bed.
void drop_heap(Simulation& simulation, double speed) {
  auto heap =
      converging_cloud({3, 3, 3}, 1.1 * grain_size(), 0.01, 8, Eigen::Vector3d(-4, -4, 11) * grain_size());
  for (auto& grain : heap) grain.velocity.z() -= speed;
  simulation.add_grains(heap);
}

double weight(const Simulation& simulation) {
  const auto& settings = simulation.settings();
  return static_cast<double>(simulation.grains().size()) * settings.shape().mass * settings.gravity.norm();
}

double mean_height(const Simulation& simulation) {
  double sum = 0;
  for (const auto& position : simulation.grains().position) sum += position.z();
  return sum / static_cast<double>(simulation.grains().size());
}

TEST(Sleeping, SettledBedSleepsAndStands) {
  auto simulation = sleeping_bed();
  const std::size_t grains = simulation.grains().size();
  EXPECT_GT(sleepers(simulation), grains * 9 / 10);
  simulation.step();
  // The tool still carries all of it.
  EXPECT_NEAR(simulation.wall_load(0).force.z(), -weight(simulation), 0.02 * weight(simulation));
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-2);
  EXPECT_LT(simulation.ledger().sleep_work, 0);
  const Snapshot before = simulation.snapshot();
  run_steps(simulation, 2000);
  EXPECT_GT(sphere_steps_left_out(simulation) - before.sleep.sphere_steps_left_out, 2000 * grains / 2);
  for (std::size_t k = 0; k < grains; ++k) {
    const std::size_t now = place_of(simulation, before.grains.id[k]);
    if (!before.sleep.asleep[k] || !asleep(simulation, now)) continue;
    EXPECT_LT((before.grains.position[k] - simulation.grains().position[now]).norm(), 0.01 * grain_size());
  }
}

/// Two beds from the same state, one of which may sleep, 20 ms later.
struct Beds {
  Simulation asleep = empty_box(true), awake = empty_box(false);
  Beds() {
    for (Simulation* bed : {&asleep, &awake}) {
      bed->restore(settled(false));
      run_steps(*bed, 5000);
    }
  }
};

TEST(Sleeping, BedIsTheOneThatStaysAwake) {
  const Beds beds;
  EXPECT_GT(sleepers(beds.asleep), beds.asleep.grains().size() * 8 / 10);
  EXPECT_EQ(sleepers(beds.awake), 0U);
  EXPECT_EQ(sphere_steps_left_out(beds.awake), 0U);
  EXPECT_NEAR(mean_height(beds.asleep), mean_height(beds.awake), 1e-3 * grain_size());
  std::size_t elsewhere = 0;
  for (std::uint64_t id = 0; id < beds.asleep.grains().size(); ++id)
    elsewhere += (position_of(beds.asleep, id) - position_of(beds.awake, id)).norm() > 0.02 * grain_size();
  EXPECT_LT(elsewhere, beds.asleep.grains().size() / 100) << "but for a few that roll about";
  EXPECT_NEAR(beds.asleep.wall_load(0).force.z(), beds.awake.wall_load(0).force.z(),
              0.01 * weight(beds.awake));
  EXPECT_NEAR(static_cast<double>(beds.asleep.touching_pairs()),
              static_cast<double>(beds.awake.touching_pairs()),
              0.02 * static_cast<double>(beds.awake.touching_pairs()));
}

TEST(Sleeping, FallingGrainsWakeWhatTheyHit) {
  Beds beds;
  const std::size_t grains = beds.asleep.grains().size(), at_first = sleepers(beds.asleep);
  for (Simulation* bed : {&beds.asleep, &beds.awake}) drop_heap(*bed, 0);
  std::size_t fewest = at_first;
  for (int k = 0; k < 10000; ++k) {
    beds.asleep.step();
    beds.awake.step();
    fewest = std::min(fewest, sleepers(beds.asleep));
  }
  EXPECT_LT(fewest, at_first - 20);
  EXPECT_GT(fewest, at_first / 10) << "far from the impact some sleep on";
  // The heap lies on the bed, as high as on the one that is awake.
  double heap_asleep = 0, heap_awake = 0;
  for (std::uint64_t id = grains; id < grains + 27; ++id) {
    heap_asleep += position_of(beds.asleep, id).z() / 27;
    heap_awake += position_of(beds.awake, id).z() / 27;
  }
  EXPECT_NEAR(heap_asleep, heap_awake, 0.5 * grain_size());
  EXPECT_NEAR(mean_height(beds.asleep), mean_height(beds.awake), 0.02 * grain_size());
  EXPECT_LT(beds.asleep.overlaps_of_run().grains, 0.2 * beds.asleep.settings().shape().sphere_radius);
  EXPECT_LT(std::abs(energy_balance_error(beds.asleep)), 1e-2);
  run_steps(beds.asleep, 20000);
  EXPECT_GT(sleepers(beds.asleep), at_first * 8 / 10) << "in the end they sleep again";
}

TEST(Sleeping, ToolThatSetsOutWakesThePowder) {
  const double start = settled(true).time;
  const auto lower = [start](double time) {
    BodyMotion motion;
    const double since = std::max(0.0, time - start - 1e-3);
    motion.translation.z() = -0.5 * 9.81 * since * since;
    motion.velocity.z() = -9.81 * since;
    return motion;
  };
  auto simulation = sleeping_bed(1, lower);
  run_steps(simulation, 200);
  EXPECT_GT(sleepers(simulation), simulation.grains().size() * 8 / 10) << "the plate still stands";
  const double height = mean_height(simulation);
  run_steps(simulation, 5000);
  EXPECT_EQ(sleepers(simulation), 0U);
  // The bed falls with the plate, the upper layers a look later than those that carried them.
  const double since = 5200 * kStep - 1e-3, look = static_cast<double>(kStepsPerCheck) * kStep;
  const double fallen = 0.5 * 9.81 * since * since;
  EXPECT_NEAR(height - mean_height(simulation), fallen, 9 * look * 9.81 * since);
}

TEST(Sleeping, GrainsTakenAwayWakeTheirNeighbours) {
  auto simulation = sleeping_bed();
  // A pit down to the plate: its rim has nothing to lean on.
  const double pit = 4 * grain_size();
  const auto in_pit = [&](const Eigen::Vector3d& place) { return place.head<2>().norm() < pit; };
  simulation.remove_grains(in_pit);
  run_steps(simulation, 2000);
  EXPECT_LT(sleepers(simulation), simulation.grains().size());
  run_steps(simulation, 8000);
  std::size_t inside = 0;
  for (const auto& place : simulation.grains().position) inside += in_pit(place) ? 1U : 0U;
  EXPECT_GT(inside, 10U) << "grains slide into the pit";
}

TEST(Sleeping, StopsAndGoesOnBitForBit) {
  const auto start = [] {
    auto simulation = sleeping_bed();
    drop_heap(simulation, 0.3);
    return simulation;
  };
  auto unbroken = start();
  run_steps(unbroken, 6000);
  for (const int stop : {3, 457, 1111, 2005, 4003}) {
    auto broken = start();
    run_steps(broken, stop);
    auto resumed = empty_box(true);
    resumed.restore(broken.snapshot());
    EXPECT_EQ(sleepers(resumed), sleepers(broken));
    run_steps(resumed, 6000 - stop);
    EXPECT_EQ(resumed.hash(), unbroken.hash()) << stop;
    EXPECT_EQ(sleepers(resumed), sleepers(unbroken));
    EXPECT_EQ(resumed.wall_load(0).force, unbroken.wall_load(0).force);
    EXPECT_EQ(resumed.ledger().expected(), unbroken.ledger().expected());
    EXPECT_EQ(sphere_steps_left_out(resumed), sphere_steps_left_out(unbroken));
  }
  EXPECT_GT(sleepers(unbroken), 0U);
  EXPECT_LT(sleepers(unbroken), unbroken.grains().size());
}

TEST(Sleeping, IsTheSameOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes, saved;
  for (const int threads : {1, 2, 3}) {
    auto simulation = sleeping_bed(threads);
    drop_heap(simulation, 0.3);
    run_steps(simulation, 4000);
    hashes.push_back(simulation.hash());
    saved.push_back(sphere_steps_left_out(simulation));
  }
  EXPECT_EQ(hashes, std::vector<std::uint64_t>(3, hashes.front()));
  EXPECT_EQ(saved, std::vector<std::uint64_t>(3, saved.front()));
}

TEST(Sleeping, ClumpsSleepToo) {
  auto settings = weightless(Model::d, {.friction = 1, .work_of_adhesion = 0.005}, 4e-6);
  settings.gravity = {0, 0, -9.81};
  settings.sleep = SleepSettings{};
  const double size = 2 * half_size(settings.shape());
  // The plate's spheres repeat with the period: a grain that crosses it must find the same wall again.
  constexpr double kWallRadius = 1.5e-4, kSpacing = 1.6 * kWallRadius;
  const double period = std::ceil(5 * size / kSpacing) * kSpacing;
  settings.period = {period, period};
  Simulation simulation(settings, {plate(4 * size, kWallRadius)});
  simulation.add_grains(converging_cloud({4, 4, 4}, 1.1 * size, 0.05, 4, {0, 0, 2.6 * size}));
  run_steps(simulation, 40000);
  EXPECT_GT(sleepers(simulation), simulation.grains().size() / 2);
  EXPECT_NEAR(simulation.wall_load(0).force.z(), -weight(simulation), 0.02 * weight(simulation));
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-2);
}

TEST(Sleeping, RefusesLimitsThatAreNone) {
  auto settings = bed_settings(true);
  settings.sleep->time = 0;
  EXPECT_THROW(Simulation(settings, {}), std::invalid_argument);
  settings.sleep = SleepSettings{};
  settings.sleep->force = -1;
  EXPECT_THROW(Simulation(settings, {}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
