// Beds of spheres with rolling resistance come to rest at the default step and gain no energy, whatever the
// resistance and however many contacts a grain has.
#include <gtest/gtest.h>

#include "engine/limits/time_step.h"
#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kRadius = 1.25e-3, kMass = 2.05e-5;              // m, kg
constexpr double kModulus = 0.5e6, kShear = 0.1e6, kLinear = 50;  // Pa, N/m
constexpr double kFall = 1.6;                                     // m/s, of a pour from 0.13 m

/// Soft spheres with Hertz' spring, or a linear one.
laws::LawParameters soft(const laws::AnyRolling::Parameters& rolling, bool linear) {
  laws::LawParameters law{.normal = laws::HertzMindlinNormal::Parameters{.modulus = kModulus}};
  law.damping = laws::RestitutionDamping::Parameters{.restitution = 0.6, .modulus = kModulus};
  if (linear) {
    law.normal = laws::LinearNormal::Parameters{.stiffness = kLinear};
    law.damping = laws::LinearRestitutionDamping::Parameters{.restitution = 0.6, .stiffness = kLinear};
  }
  law.friction =
      laws::MindlinFriction::Parameters{.shear_modulus = kShear, .friction = 0.3, .restitution = 0.6};
  law.rolling = rolling;
  return law;
}

SimulationSettings soft_spheres(const laws::LawParameters& law, int threads = 1) {
  SimulationSettings settings;
  settings.types = {{model_b(kRadius, kMass)}};
  const GeneralContact contact{law, law};
  settings.contact = contact;
  settings.time_step = kDefaultTimeStepFraction * critical_time_step(settings.shape(), contact, kFall);
  settings.threads = threads;
  return settings;
}

/// A loose lattice on a plane, periodic in x and y.
Simulation bed_of(SimulationSettings settings, int across, int layers) {
  const double spacing = 2.1 * settings.shape().sphere_radius;
  settings.period = {across * spacing, across * spacing};
  WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  Simulation simulation(settings, {floor});
  std::mt19937_64 random(2);
  std::vector<NewGrain> grains(static_cast<std::size_t>(across * across * layers));
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const int n = static_cast<int>(k);
    grains[k].position =
        spacing * Eigen::Vector3d(n % across, n / across % across, n / across / across + 0.6) +
        random_vector(random, 0.03 * settings.shape().sphere_radius);
    grains[k].velocity = random_vector(random, 0.05);
  }
  simulation.add_grains(grains);
  return simulation;
}

void run_until(Simulation& simulation, double time) {
  while (simulation.time() < time) simulation.step();
}

struct RollingCase {
  std::string name;
  laws::AnyRolling::Parameters rolling;
  bool linear = false;
};

class RollingRest : public ::testing::TestWithParam<RollingCase> {};

TEST_P(RollingRest, BedComesToRestAndItsEnergyBalances) {
  auto simulation = bed_of(soft_spheres(soft(GetParam().rolling, GetParam().linear)), 5, 8);
  run_until(simulation, 0.12);
  const double taken = std::abs(simulation.ledger().rolling_work);
  EXPECT_GT(taken, 0);
  run_until(simulation, 0.24);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 0.005);
  // Nothing rolls any more, and so nothing is taken.
  EXPECT_LT(std::abs(simulation.ledger().rolling_work) - taken, 0.01 * taken);
  EXPECT_LT(energy_of(simulation).rotation, 1e-3 * taken);
}

INSTANTIATE_TEST_SUITE_P(
    Resistances, RollingRest,
    ::testing::Values(
        RollingCase{"CDT", laws::LoadRolling::Parameters{.rolling_friction = 0.1}},
        RollingCase{"strong_CDT", laws::LoadRolling::Parameters{.rolling_friction = 1}},
        RollingCase{"elastic_CDT",
                    laws::ElasticRolling::Parameters{.rolling_friction = 0.1, .stiffness = kLinear}, true},
        RollingCase{"EPSD2",
                    laws::Epsd2Rolling::Parameters{.rolling_friction = 0.2, .shear_modulus = kShear}}),
    [](const auto& instance) { return instance.param.name; });

TEST(RollingRestOfTheTunedLaw, BierwischsTorqueGainsNoEnergy) {
  SimulationSettings settings;
  settings.types = {{model_b(kRadius, kMass)}};
  grain_contact(settings) = {.reduced_modulus = 1e6, .damping = 300, .tangential = 600, .friction = 1};
  grain_contact(settings)->rolling_friction = 2.5 * kRadius;  // as fitted for B1
  wall_contact(settings) = grain_contact(settings);
  settings.time_step =
      kDefaultTimeStepFraction * critical_time_step(settings.shape(), grain_contact(settings), kFall);
  auto simulation = bed_of(settings, 5, 8);
  run_until(simulation, 0.24);
  EXPECT_LT(simulation.ledger().rolling_work, 0);
  EXPECT_LT(energy_balance_error(simulation), 0.005);
}

// The printed torque at rest: 0.5 mu_r R m g dt / I, with which the sphere would oscillate.
TEST(ConstantTorqueAtRest, HoldsASphereStill) {
  const auto settings = soft_spheres(soft(laws::LoadRolling::Parameters{.rolling_friction = 1}, false));
  WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  Simulation simulation(settings, {floor});
  NewGrain grain;
  grain.position.z() = kRadius - 2e-5;
  grain.angular_velocity = {0, 20, 0};
  simulation.add_grains({grain});
  run_until(simulation, 0.5);
  const double chatter = 0.5 * kRadius * kMass * 9.81 * settings.time_step / settings.shape().inertia.x();
  EXPECT_LT(simulation.angular_velocity(0).norm(), 1e-3 * chatter);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 0.005);
}

// The torque's history goes into a restart, and no order of threads shows in it.
TEST(ConstantTorqueAtRest, ThreadsAndARestartChangeNoBit) {
  const auto law = soft(laws::LoadRolling::Parameters{.rolling_friction = 0.1}, false);
  auto whole = bed_of(soft_spheres(law), 5, 8), threaded = bed_of(soft_spheres(law, 2), 5, 8);
  run_steps(whole, 1500);
  run_steps(threaded, 1500);
  EXPECT_EQ(whole.hash(), threaded.hash());
  const Snapshot snapshot = whole.snapshot();
  run_steps(whole, 500);
  threaded.restore(snapshot);
  run_steps(threaded, 500);
  EXPECT_EQ(whole.hash(), threaded.hash());
}

}  // namespace
}  // namespace diefill::engine
