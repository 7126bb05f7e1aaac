// The longest stable step between springs and dampers, compared with the engine's own steps.
#include "engine/limits/stable_step.h"

#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kMass = 1e-6, kStiffness = 500, kRadius = 1e-3;  // kg, N/m, m

/// Swing (m) that 400 steps of `time_step` (s) make of 1e-9 m, for a sphere that rests on a plane by a linear
/// spring and a dashpot of `damping` (kg/s).
double swing_after(double damping, double time_step) {
  constexpr double kSwing = 1e-9, kGravity = 100;
  SimulationSettings settings;
  settings.types = {{model_a(kRadius, kMass)}};
  GeneralContact contact;
  contact.grains.normal = contact.walls.normal = laws::LinearNormal::Parameters{kStiffness};
  if (damping > 0)
    contact.grains.damping = contact.walls.damping = laws::ConstantDamping::Parameters{damping};
  settings.contact = contact;
  settings.gravity = {0, 0, -kGravity};
  settings.time_step = time_step;
  WallBodySpec floor;
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  Simulation simulation(settings, {floor});
  const double rest = kRadius - kMass * kGravity / kStiffness;
  NewGrain grain;
  grain.position = {0, 0, rest + kSwing};
  simulation.add_grains({grain});
  double swing = 0;
  for (int step = 0; step < 400; ++step) {
    simulation.step();
    // The last of the swing: what has died away or built up.
    if (step > 390) swing = std::max(swing, std::abs(simulation.grains().position[0].z() - rest));
  }
  return swing;
}

TEST(StableStep, IsWhereARestingSphereBeginsToSwingUp) {
  const double critical_damping = 2 * std::sqrt(kStiffness * kMass);
  for (const double damping : {0.2, 1.0, 5.0, 40.0}) {
    const double limit = stable_step(kMass, kStiffness, damping * critical_damping);
    EXPECT_LT(swing_after(damping * critical_damping, 0.97 * limit), 1e-9) << damping;
    EXPECT_GT(swing_after(damping * critical_damping, 1.03 * limit), 1e-8) << damping;
  }
}

TEST(StableStep, HasTheLimitsOfASpringAloneAndOfADamperAlone) {
  EXPECT_DOUBLE_EQ(stable_step(kMass, kStiffness, 0), 2 * std::sqrt(kMass / kStiffness));
  EXPECT_DOUBLE_EQ(stable_step(kMass, 0, 3), kMass / 3);
}

}  // namespace
}  // namespace diefill::engine
