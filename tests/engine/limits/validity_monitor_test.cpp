// A run that leaves the method's range stops with a line that says what to change.
#include "engine/limits/validity_monitor.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/limits/time_step.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// Message with which `check` stops, or an empty one.
std::string complaint(ValidityMonitor& monitor, const Simulation& simulation) {
  try {
    monitor.check(simulation);
  } catch (const OutOfRange& error) {
    return error.what();
  }
  return {};
}

Simulation pair_with_overlap(double over_radius, double time_step) {
  auto settings = weightless(Model::a, {}, time_step);
  Simulation simulation(settings, {});
  NewGrain left, right;
  right.position.x() = (2 - over_radius) * settings.shape().sphere_radius;
  simulation.add_grains({left, right});
  simulation.step();
  return simulation;
}

TEST(ValidityMonitor, QuietWhileAllIsWell) {
  auto settings = weightless(Model::d, {.friction = 0.5, .work_of_adhesion = 0.01}, 1e-6);
  settings.gravity = {0, 0, -9.81};
  Simulation simulation(settings, {});
  simulation.add_grains(converging_cloud({3, 3, 3}, 2 * half_size(settings.shape()), 0.3, 2));
  ValidityMonitor monitor;
  for (int round = 0; round < 10; ++round) {
    run_steps(simulation, 50);
    EXPECT_EQ(complaint(monitor, simulation), "");
  }
  EXPECT_TRUE(monitor.warnings().empty());
}

TEST(ValidityMonitor, NamesTheGrainWithNoFiniteState) {
  auto settings = weightless(Model::a, {}, 1e-6);
  Simulation simulation(settings, {});
  NewGrain good, bad;
  bad.position.x() = 1e-3;
  bad.velocity.y() = std::numeric_limits<double>::infinity();
  simulation.add_grains({good, bad});
  ValidityMonitor monitor;
  EXPECT_NE(complaint(monitor, simulation).find("grain 1 has no finite position or velocity"),
            std::string::npos);
}

TEST(ValidityMonitor, StopsAtForbiddenOverlapAndWarnsBefore) {
  ValidityMonitor monitor;
  const auto shallow = pair_with_overlap(0.1, 1e-9);
  EXPECT_EQ(complaint(monitor, shallow), "");
  EXPECT_TRUE(overlap_warnings(shallow).empty());
  const auto doubtful = pair_with_overlap(0.3, 1e-9);
  EXPECT_EQ(complaint(monitor, doubtful), "");
  ASSERT_EQ(overlap_warnings(doubtful).size(), 1U);
  EXPECT_NE(overlap_warnings(doubtful)[0].find("overlap among grains reached 0.3 "), std::string::npos);
  const std::string message = complaint(monitor, pair_with_overlap(0.7, 1e-9));
  EXPECT_NE(message.find("overlap by 0.70 of their radius"), std::string::npos) << message;
  EXPECT_NE(message.find("reduced_modulus"), std::string::npos);
}

/// A sphere of radius 1.5e-4 m held `ratio` of its radius deep in a plane of one large wall sphere for one
/// step.
Simulation pressed_into_wall(double ratio) {
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1e-9);
  Simulation simulation(settings, {plate(1e-3, 1.5e-4)});
  NewGrain grain;
  grain.position.z() = (1 - ratio) * settings.shape().sphere_radius;
  simulation.add_grains({grain});
  run_steps(simulation, 1);
  return simulation;
}

TEST(ValidityMonitor, ReportsAGrainPinchedByAToolAndStopsBeforeItIsPushedThrough) {
  ValidityMonitor monitor;
  EXPECT_EQ(complaint(monitor, pressed_into_wall(0.5)), "");
  EXPECT_TRUE(overlap_warnings(pressed_into_wall(0.5)).empty());
  for (const auto& [deep, reached] :
       {std::pair{0.8, "a wall reached 0.8 "}, {0.95, "a wall reached 0.95 "}}) {
    EXPECT_EQ(complaint(monitor, pressed_into_wall(deep)), "");
    const auto warnings = overlap_warnings(pressed_into_wall(deep));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("pinched a grain"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find(reached), std::string::npos) << warnings[0];
  }
  const std::string message = complaint(monitor, pressed_into_wall(1.05));
  EXPECT_NE(message.find("pressed into a wall by 1.05 of its radius"), std::string::npos) << message;
}

TEST(ValidityMonitor, StopsAtAStepAboveTheCriticalOne) {
  ValidityMonitor monitor;
  const std::string message = complaint(monitor, pair_with_overlap(0.05, 2e-4));
  EXPECT_NE(message.find("above the critical one"), std::string::npos) << message;
}

TEST(ValidityMonitor, StopsWhenEnergyComesFromNowhere) {
  // A tool that jumps into a grain without having a velocity does work that nothing explains.
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1e-6);
  Simulation simulation(settings, {plate(1e-3, 1.5e-4)});
  NewGrain grain;
  grain.position.z() = 2e-4;
  grain.velocity.x() = 0.01;
  simulation.add_grains({grain});
  run_steps(simulation, 10);
  ValidityMonitor monitor;
  EXPECT_EQ(complaint(monitor, simulation), "");
  simulation.set_motion(0, [](double) {
    BodyMotion jumped;
    jumped.translation.z() = 6e-5;
    return jumped;
  });
  simulation.step();
  const std::string message = complaint(monitor, simulation);
  EXPECT_NE(message.find("energy grew"), std::string::npos) << message;
}

TEST(ValidityMonitor, NamesTheGrainsThatOverlapMostAndTheirPlace) {
  ValidityMonitor monitor;
  const std::string message = complaint(monitor, pair_with_overlap(0.7, 1e-9));
  EXPECT_NE(message.find("deepest now between grain 0 at (0.00, 0.00, 0.00) mm and grain 1"),
            std::string::npos)
      << message;
}

/// A sphere of radius 1.5e-4 m alone, flying at `speed` (m/s), after one step of 1e-6 s.
Simulation lone_flyer(double speed) {
  Simulation simulation(weightless(Model::a, {.damping_over_radius = 0}, 1e-6), {});
  NewGrain slow, fast;
  fast.position.x() = 1e-3;
  fast.velocity.x() = speed;
  simulation.add_grains({slow, fast});
  run_steps(simulation, 1);
  return simulation;
}

TEST(ValidityMonitor, StopsAtAGrainThatPassesHalfItsRadiusInAStep) {
  ValidityMonitor monitor;
  EXPECT_EQ(complaint(monitor, lone_flyer(70)), "");
  const std::string message = complaint(monitor, lone_flyer(80));
  EXPECT_NE(message.find("grain 1 at (1.08, 0.00, 0.00) mm moves at 80 m/s"), std::string::npos) << message;
}

TEST(ValidityMonitor, WarnsOnceOfAGrainTooFastForTheStep) {
  // A collision at 2 m/s allows 2 sqrt(m_eff / k) = 1.2e-5 s; half of that gives no warning.
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1);
  const double critical =
      critical_time_step_at_overlap(settings.shape(), grain_contact(settings),
                                    impact_overlap(settings.shape(), grain_contact(settings), 2));
  for (const double share : {0.49, 0.51}) {
    settings.time_step = share * critical;
    Simulation simulation(settings, {});
    NewGrain grain;
    grain.velocity.x() = 1;
    simulation.add_grains({grain});
    run_steps(simulation, 1);
    ValidityMonitor monitor;
    EXPECT_EQ(complaint(monitor, simulation), "");
    EXPECT_EQ(complaint(monitor, simulation), "");
    EXPECT_EQ(monitor.warnings().size(), share > 0.5 ? 1U : 0U);
  }
}

/// Grains that all lie inside each other, each with a contact to every other.
Simulation heap_of(std::size_t grains) {
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1e-12);
  Simulation simulation(settings, {});
  std::vector<NewGrain> heap(grains);
  for (std::size_t k = 0; k < heap.size(); ++k)
    heap[k].position = 1e-6 * Eigen::Vector3d(static_cast<double>(k % 10), static_cast<double>(k / 10), 0);
  simulation.add_grains(heap);
  run_steps(simulation, 1);
  return simulation;
}

TEST(ValidityMonitor, WarnsNoMoreOfWhatItWasRestoredWith) {
  ValidityLimits limits;
  limits.largest_overlap = 3;
  ValidityMonitor monitor(limits), resumed(limits);
  EXPECT_EQ(complaint(monitor, heap_of(20)), "");
  ASSERT_EQ(monitor.warnings().size(), 1U);
  EXPECT_NE(monitor.warnings()[0].find("9.5 contacts a sphere"), std::string::npos) << monitor.warnings()[0];
  resumed.restore(monitor.state());
  EXPECT_EQ(complaint(resumed, heap_of(22)), "");
  EXPECT_EQ(resumed.warnings(), monitor.warnings());
}

TEST(ValidityMonitor, StopsWhenGrainsLieInsideEachOther) {
  ValidityLimits limits;
  limits.largest_overlap = 3;
  ValidityMonitor monitor(limits);
  const std::string message = complaint(monitor, heap_of(100));
  EXPECT_NE(message.find("49.5 contacts a sphere"), std::string::npos) << message;
}

/// Runs on and looks in the end, as a run does; returns the message that stopped it.
std::string end_of(Simulation& simulation, int steps) {
  try {
    run_steps(simulation, steps);
  } catch (const OutOfRange& error) {
    return error.what();
  }
  ValidityMonitor monitor;
  return complaint(monitor, simulation);
}

TEST(ValidityMonitor, ExplodedRunEndsInOneLine) {
  // Far too long a step: grains fly apart beyond all numbers before anyone looks.
  auto settings = weightless(Model::d, {.friction = 0.5}, 5e-3);
  settings.gravity = {0, 0, -9.81};
  Simulation simulation(settings, {plate(2e-3, 1.5e-4)});
  simulation.add_grains(converging_cloud({3, 3, 3}, 0.8 * 2 * half_size(settings.shape()), 0.3, 2));
  const std::string message = end_of(simulation, 200);
  EXPECT_NE(message.find("shorter"), std::string::npos) << message;
}

TEST(ValidityMonitor, TwoGrainsInOnePlaceEndInOneLine) {
  auto settings = weightless(Model::a, {.friction = 0.5}, 1e-5);
  Simulation simulation(settings, {});
  NewGrain twin, runner;
  runner.position.x() = 1e-3;
  runner.velocity.x() = 1;
  simulation.add_grains({twin, twin, runner});
  const std::string message = end_of(simulation, 200);
  EXPECT_NE(message.find("overlap by 2.00 of their radius"), std::string::npos) << message;
  EXPECT_NE(message.find("between grain 0 at (0.00, 0.00, 0.00) mm and grain 1"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace diefill::engine
