// Grains that sleep in the frame of a tool that moves: they ride along as a block.
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "engine/observe/powder_figures.h"
#include "engine/simulation/sleep_rules.h"
#include "tests/engine/engine_test_support.h"
#include "tests/engine/touching_pairs.h"

namespace diefill::engine {
namespace {

constexpr double kStep = 4e-6;        // s
constexpr double kSpeed = 0.1;        // m/s, of the tray
constexpr double kSetsOut = 0.14;     // s, when the tray sets out
constexpr double kSpeedingUp = 0.02;  // s
constexpr std::size_t kTray = 0;      // of the bodies

double grain_size(Model model) {
  return 2 * half_size(thesis_shape(model));
}

/// Rests, speeds up from kSetsOut on, goes on.
BodyMotion tray_motion(double time) {
  const double since = std::clamp(time - kSetsOut, 0.0, kSpeedingUp), after = time - kSetsOut - kSpeedingUp;
  BodyMotion motion;
  motion.velocity.x() = kSpeed * since / kSpeedingUp;
  motion.translation.x() = 0.5 * motion.velocity.x() * since + kSpeed * std::max(0.0, after);
  return motion;
}

/// A frame without bottom, drawn over a floor.
std::vector<WallBodySpec> tray_on_floor(double half_width) {
  WallBodySpec tray, floor;
  tray.name = "tray";
  for (const Eigen::Vector3d& inwards : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0),
                                         Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0)})
    tray.planes.push_back({-half_width * inwards, inwards});
  tray.motion = tray_motion;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  floor.material = "floor";
  return {tray, floor};
}

/// A bed of grains in the tray. `carries`: as a block where it is calm.
Simulation filled_tray(Model model, bool carries, int threads = 1, double floor_friction = 0.1,
                       unsigned seed = 3) {
  auto settings = weightless(model, {.friction = 0.5}, kStep);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  ContactParameters floor = wall_contact(settings);
  floor.friction = floor_friction;
  settings.contact.pairs.push_back({kPowderMaterial, "floor", laws::bierwisch_law(floor)});
  if (carries) settings.sleep = co_moving_with(kTray);
  const double size = grain_size(model);
  Simulation simulation(settings, tray_on_floor(3.5 * size));
  simulation.add_grains(converging_cloud({6, 6, 5}, 1.1 * size, 0.02, seed, {0, 0, 2.8 * size}));
  return simulation;
}

/// With the tray at its speed for 90 ms.
Simulation tray_under_way(Model model, bool carries, int threads = 1, unsigned seed = 3) {
  auto simulation = filled_tray(model, carries, threads, 0.1, seed);
  run_steps(simulation, static_cast<int>((kSetsOut + kSpeedingUp + 0.09) / kStep));
  return simulation;
}

Eigen::Vector3d mean_place(const Simulation& simulation) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& position : simulation.grains().position) sum += position;
  return sum / static_cast<double>(simulation.grains().size());
}

class CoMovingPowder : public ::testing::TestWithParam<Model> {};

TEST_P(CoMovingPowder, RidesAlongAndStaysAsItIs) {
  auto simulation = tray_under_way(GetParam(), true);
  const std::size_t grains = simulation.grains().size();
  ASSERT_GT(sleepers(simulation), grains * 9 / 10);
  const Snapshot before = simulation.snapshot();
  const Eigen::Vector3d place = mean_place(simulation);
  constexpr int kSteps = 2500;
  run_steps(simulation, kSteps);
  const Eigen::Vector3d way = mean_place(simulation) - place;
  EXPECT_NEAR(way.x(), kSpeed * kSteps * kStep, 0.01 * grain_size(GetParam()));
  EXPECT_NEAR(way.tail<2>().norm(), 0, 0.02 * grain_size(GetParam()));
  EXPECT_GT(sphere_steps_left_out(simulation) - before.sleep.sphere_steps_left_out,
            kSteps * grains * simulation.settings().shape().spheres() / 2);
  const auto& velocity = simulation.grains().velocity;
  for (std::size_t k = 0; k < grains; ++k) {
    if (!asleep(simulation, k)) continue;
    EXPECT_EQ(velocity[k], Eigen::Vector3d(kSpeed, 0, 0));
  }
}

/// Those of the pairs of which at least one grain is awake: what sleeps is kept as it was when contacts were
/// searched.
SpherePairs of_the_awake(const Simulation& simulation, SpherePairs pairs) {
  const auto sleeps = [&](const SphereName& sphere) {
    return asleep(simulation, place_of(simulation, sphere.first));
  };
  std::erase_if(pairs, [&](const auto& pair) { return sleeps(pair.first) && sleeps(pair.second); });
  return pairs;
}

TEST_P(CoMovingPowder, MissesNoTouchOfThoseWhoAreAwake) {
  auto simulation = filled_tray(GetParam(), true);
  run_steps(simulation, static_cast<int>((kSetsOut + kSpeedingUp) / kStep));
  std::size_t seen_while_some_sleep = 0;
  for (int round = 0; round < 400; ++round) {
    // Grains that hit it wake some of the powder; and powder that stops all of a sudden wakes, and rushes on.
    if (round % 50 == 0)
      simulation.add_grains({{.position = simulation.body_motion(kTray).translation +
                                          Eigen::Vector3d(0, 0, 9 * grain_size(GetParam())),
                              .velocity = {kSpeed, 0, -1}}});
    if (round == 300)
      simulation.set_motion(kTray, [at = simulation.body_motion(kTray)](double) {
        BodyMotion stopped;
        stopped.translation = at.translation;
        return stopped;
      });
    run_steps(simulation, round < 300 ? 75 : 9);
    const auto expected = of_the_awake(simulation, all_touching_pairs(simulation));
    ASSERT_EQ(of_the_awake(simulation, found_pairs(simulation)), expected)
        << "after " << simulation.steps() << " steps";
    if (sleepers(simulation) > 0) seen_while_some_sleep += expected.size();
  }
  EXPECT_GT(seen_while_some_sleep, 500U);
}

/// Two awake beds of clumps, one of them nudged by 1e-12 m, come to differ by up to 0.16 of a grain by then,
/// here or there: only the mean over seeds can tell co-moving powder from awake one.
TEST_P(CoMovingPowder, IsOnAverageWhereItWouldBeAwake) {
  constexpr unsigned kSeeds = 6;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (unsigned seed = 3; seed < 3 + kSeeds; ++seed) {
    auto carried = tray_under_way(GetParam(), true, 2, seed),
         awake = tray_under_way(GetParam(), false, 2, seed);
    run_steps(carried, 5000);
    run_steps(awake, 5000);
    EXPECT_EQ(carried.time(), awake.time());
    sum += mean_place(carried) - mean_place(awake);
  }
  EXPECT_NEAR(sum.norm() / kSeeds, 0, 0.1 * grain_size(GetParam()));
}

/// The powder slides over the floor for 2 mm: friction on it takes all that the tray gives.
TEST_P(CoMovingPowder, KeepsItsAccounts) {
  auto simulation = tray_under_way(GetParam(), true);
  const Ledger before = simulation.ledger();
  const double error_before = energy_balance_error(simulation);
  run_steps(simulation, 5000);
  EXPECT_GT(sleepers(simulation), simulation.grains().size() / 2);
  EXPECT_LT(simulation.ledger().tangential_work, before.tangential_work);
  EXPECT_LT(std::abs(error_before), 5e-3);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 5e-3);
}

TEST_P(CoMovingPowder, WakesWhenItsCarrierStops) {
  auto simulation = tray_under_way(GetParam(), true);
  const BodyMotion at = simulation.body_motion(kTray);
  simulation.set_motion(kTray, [at](double) {
    BodyMotion stopped;
    stopped.translation = at.translation;
    return stopped;
  });
  simulation.step();
  EXPECT_EQ(sleepers(simulation), 0U);
  double speed = 0;
  for (const auto& velocity : simulation.grains().velocity) speed += velocity.x();
  EXPECT_GT(speed / static_cast<double>(simulation.grains().size()), 0.9 * kSpeed)
      << "it still has the speed that it was carried with";
}

TEST_P(CoMovingPowder, StopsAndGoesOnBitForBit) {
  auto unbroken = tray_under_way(GetParam(), true);
  run_steps(unbroken, 1500);
  for (const int stop : {4, 333, 1200}) {
    auto broken = tray_under_way(GetParam(), true);
    run_steps(broken, stop);
    auto resumed = filled_tray(GetParam(), true, 2);
    resumed.restore(broken.snapshot());
    run_steps(resumed, 1500 - stop);
    EXPECT_EQ(resumed.hash(), unbroken.hash()) << stop;
    EXPECT_EQ(sleepers(resumed), sleepers(unbroken));
    EXPECT_EQ(resumed.wall_load(kTray).force, unbroken.wall_load(kTray).force);
    EXPECT_EQ(resumed.wall_load(kTray).torque, unbroken.wall_load(kTray).torque);
    EXPECT_EQ(resumed.ledger().expected(), unbroken.ledger().expected());
  }
  EXPECT_GT(sleepers(unbroken), unbroken.grains().size() / 2);
}

TEST_P(CoMovingPowder, IsTheSameOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3}) hashes.push_back(tray_under_way(GetParam(), true, threads).hash());
  EXPECT_EQ(hashes, std::vector<std::uint64_t>(3, hashes.front()));
}

INSTANTIATE_TEST_SUITE_P(Grains, CoMovingPowder, ::testing::Values(Model::a, Model::d));

TEST(CoMovingPowder, WakesWhereItIsToBeAwake) {
  const double size = grain_size(Model::a);
  auto settings = filled_tray(Model::a, true).settings();
  const double from = mean_place(tray_under_way(Model::a, true)).x() + size;
  settings.sleep->awake = {{Eigen::Vector3d(from, -1, -1), Eigen::Vector3d(1, 1, 1)}};
  Simulation simulation(settings, tray_on_floor(3.5 * size));
  simulation.restore(tray_under_way(Model::a, true).snapshot());
  for (int look = 0; look < 100; ++look) {
    run_steps(simulation, static_cast<int>(kStepsPerCheck));
    for (std::size_t k = 0; k < simulation.grains().size(); ++k)
      ASSERT_FALSE(asleep(simulation, k) && simulation.grains().position[k].x() > from) << "at look " << look;
  }
  EXPECT_GT(sleepers(simulation), simulation.grains().size() / 4) << "behind, it rides on";
  EXPECT_LT(sleepers(simulation), simulation.grains().size() * 3 / 4);
}

}  // namespace
}  // namespace diefill::engine
