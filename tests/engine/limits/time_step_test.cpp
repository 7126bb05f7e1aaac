// The critical time step: its closed forms, and steps beyond it that fail.
#include "engine/limits/time_step.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "engine/numerics/out_of_range.h"
#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

ContactParameters undamped() {
  return {.reduced_modulus = 1e7};
}

TEST(TimeStep, GrainIsLighterOnItsArms) {
  EXPECT_DOUBLE_EQ(mobility(thesis_shape(Model::a)), 1);
  EXPECT_DOUBLE_EQ(mobility(thesis_shape(Model::b)), 1);
  EXPECT_NEAR(mobility(thesis_shape(Model::d)), 2.49, 0.005);
}

TEST(TimeStep, ImpactOverlapIsThatOfTheTable) {
  const auto shape = thesis_shape(Model::d);
  const std::array<std::pair<double, double>, 5> table = {
      {{0.01, 0.0054}, {0.1, 0.034}, {0.2, 0.059}, {0.5, 0.12}, {1.0, 0.21}}};
  for (const auto& [speed, over_radius] : table)
    EXPECT_NEAR(impact_overlap(shape, undamped(), speed) / shape.sphere_radius, over_radius,
                0.03 * over_radius);
}

TEST(TimeStep, LimitsOfContactAndDamperAreThoseOfTheReference) {
  const auto shape = thesis_shape(Model::d);
  const double lighter = mobility(shape);
  EXPECT_NEAR(
      critical_time_step_at_overlap(shape, undamped(), 0.2 * shape.sphere_radius) * std::sqrt(lighter),
      2.5e-5, 0.05e-5);
  auto damped = undamped();
  damped.damping = 1e7 * shape.sphere_radius;
  EXPECT_NEAR(critical_time_step_at_overlap(shape, damped, 0.06 * shape.sphere_radius) * lighter, 7e-6,
              0.5e-6);
}

TEST(TimeStep, ScalesWithTheGrainAndFallsWithSpeedAndStiffness) {
  const double step = critical_time_step(thesis_shape(Model::d), undamped(), 0.7);
  EXPECT_NEAR(critical_time_step(model_d(2 * 7.84e-5, 8 * 7.63e-8), undamped(), 0.7), 2 * step, 1e-9 * step);
  EXPECT_NEAR(critical_time_step(thesis_shape(Model::d), undamped(), 2.1), step * std::pow(3, -0.2),
              1e-9 * step);
  EXPECT_NEAR(critical_time_step(thesis_shape(Model::d), {.reduced_modulus = 1e9}, 0.7),
              step * std::pow(100, -0.4), 1e-9 * step);
}

TEST(TimeStep, DefaultFractionResolvesACollisionByADozenSteps) {
  for (const Model model : {Model::a, Model::d})
    for (const double speed : {0.1, 1.0}) {
      const auto settings = weightless(model, {.damping_over_radius = 0}, 1e-7);
      const double duration = collide_head_on(settings, speed).duration;
      EXPECT_GT(duration,
                12 * kDefaultTimeStepFraction * critical_time_step(settings.shape(), undamped(), speed));
    }
}

TEST(TimeStep, PinchMeetsOneWallSphereASideOnCoarseWallsAndManyOnFineOnes) {
  const GrainShape shape = model_a(1e-3, 1e-6);
  const double overlap = 1e-4;
  // Walls of spheres far apart: one contact a side, two springs on the whole mass.
  const double root = std::sqrt(effective_radius(1e-3, 1e-3) * overlap);
  EXPECT_NEAR(pinch_time_step(shape, undamped(), 1e-3, 1e-2, overlap), 2 * std::sqrt(1e-6 / (2 * 1e7 * root)),
              1e-12);
  // Half the distance between wall spheres meets four times as many, half as much room squared.
  const double fine = pinch_time_step(shape, undamped(), 1e-4, 1e-4, overlap);
  const double finer = pinch_time_step(shape, undamped(), 1e-4, 5e-5, overlap);
  EXPECT_NEAR(finer / fine, 0.5, 1e-9);
  // Flat walls are met once a side, too.
  constexpr double kFlat = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(pinch_time_step(shape, undamped(), kFlat, kFlat, overlap),
              2 * std::sqrt(1e-6 / (2 * 1e7 * std::sqrt(1e-3 * overlap))), 1e-12);
}

/// Energy of a bed of colliding grains after a while, over that at the start, undamped.
double energy_ratio(double fraction) {
  auto settings = weightless(Model::d, {.damping_over_radius = 0}, 1);
  settings.time_step = fraction * critical_time_step(settings.shape(), grain_contact(settings), 1.0);
  Simulation simulation(settings, {});
  auto cloud = converging_cloud({4, 4, 4}, 2 * half_size(settings.shape()), 0.5, 12);
  simulation.add_grains(cloud);
  const double before = energy_of(simulation).total();
  run_steps(simulation, static_cast<int>(4e-3 / settings.time_step));
  return energy_of(simulation).total() / before;
}

TEST(TimeStep, DefaultFractionKeepsEnergyAndTwiceTheCriticalExplodes) {
  EXPECT_NEAR(energy_ratio(kDefaultTimeStepFraction), 1, 0.01);
  EXPECT_THROW(energy_ratio(2), OutOfRange);
}

TEST(TimeStep, SimulationRefusesStepsThatAreNotPositive) {
  for (const double bad : {0.0, -1e-6, std::nan("")})
    EXPECT_THROW(Simulation(weightless(Model::a, {}, bad), {}), std::invalid_argument);
  auto settings = weightless(Model::a, {}, 1e-6);
  settings.threads = 0;
  EXPECT_THROW(Simulation(settings, {}), std::invalid_argument);
  settings.threads = 1;
  settings.shape().sphere_offsets.clear();
  EXPECT_THROW(Simulation(settings, {}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
