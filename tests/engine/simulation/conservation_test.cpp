// What nature keeps: momentum, angular momentum, energy; in clouds of colliding grains and in free tops.
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

Simulation colliding_cloud(double time_step, const Powder& powder, LeverArm arm, Model model = Model::d) {
  auto settings = weightless(model, powder, time_step);
  settings.lever_arm = arm;
  Simulation simulation(settings, {});
  const double size = 2 * half_size(settings.shape());
  auto cloud = converging_cloud({3, 3, 3}, 1.05 * size, 0.3, 11);
  simulation.add_grains(cloud);
  return simulation;
}

constexpr double kDuration = 1e-3;  // s, several collisions a grain

void run_for(Simulation& simulation, double duration) {
  run_steps(simulation, static_cast<int>(std::lround(duration / simulation.settings().time_step)));
}

TEST(Conservation, MomentumStaysToRounding) {
  for (const LeverArm arm : {LeverArm::center, LeverArm::contact}) {
    auto simulation = colliding_cloud(1e-6, {.friction = 0.5, .work_of_adhesion = 0.01}, arm);
    const Eigen::Vector3d before = momentum(simulation);
    run_for(simulation, kDuration);
    EXPECT_LT(simulation.ledger().viscous_work, -1e-12);
    EXPECT_LT(simulation.ledger().tangential_work, -1e-12);
    const double scale = 27 * simulation.settings().shape().mass * 0.3;
    EXPECT_LT((momentum(simulation) - before).norm(), 1e-14 * scale);
  }
}

/// Change of angular momentum over the sum of what the grains hold (size of a grain times its momentum).
double angular_momentum_change(double time_step, LeverArm arm) {
  auto simulation = colliding_cloud(time_step, {.friction = 0.5}, arm);
  const Eigen::Vector3d before = angular_momentum(simulation);
  run_for(simulation, kDuration);
  const auto& shape = simulation.settings().shape();
  return (angular_momentum(simulation) - before).norm() / (27 * shape.mass * 0.3 * half_size(shape));
}

TEST(Conservation, ForcesAtTheContactKeepAngularMomentum) {
  // D grains are spherical tops: the scheme itself loses nothing, so the change is rounding at any step.
  for (const double time_step : {1e-6, 2.5e-7})
    EXPECT_LT(angular_momentum_change(time_step, LeverArm::contact), 1e-13);
}

TEST(Conservation, ForcesAtSphereCentresDoNot) {
  // OP-2: the literal Eq. 2.16 leaves out the arm from sphere centre to contact.
  for (const double time_step : {1e-6, 2.5e-7})
    EXPECT_GT(angular_momentum_change(time_step, LeverArm::center), 1e-2);
}

struct LedgerCase {
  const char* name;
  Model model;
  LeverArm arm;
};

class LedgerOfCloud : public ::testing::TestWithParam<LedgerCase> {};

TEST_P(LedgerOfCloud, ClosesAndClosesBetterWithShorterSteps) {
  const auto error = [](double time_step) {
    auto simulation =
        colliding_cloud(time_step, {.friction = 0.5, .work_of_adhesion = 0.01, .rolling_friction = 3.75e-5},
                        GetParam().arm, GetParam().model);
    run_for(simulation, kDuration);
    return std::abs(energy_balance_error(simulation));
  };
  const double coarse = error(1e-6), fine = error(1e-7);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, 0.3 * coarse);
}

INSTANTIATE_TEST_SUITE_P(Models, LedgerOfCloud,
                         ::testing::Values(LedgerCase{"A", Model::a, LeverArm::none},
                                           LedgerCase{"B", Model::b, LeverArm::surface},
                                           LedgerCase{"C", Model::c, LeverArm::contact},
                                           LedgerCase{"DCenter", Model::d, LeverArm::center},
                                           LedgerCase{"DContact", Model::d, LeverArm::contact}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Ledger, AirAndGravityAreBooked) {
  auto settings = weightless(Model::d, {}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 2e-5;
  Simulation simulation(settings, {});
  NewGrain grain;
  grain.velocity = {0.5, 0, 0};
  grain.angular_velocity = {300, 200, -100};
  simulation.add_grains({grain});
  run_steps(simulation, 20000);
  EXPECT_LT(simulation.ledger().drag_work, 0);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-4);
}

TEST(Ledger, StokesDragHasItsRelaxationTime) {
  auto settings = weightless(Model::d, {}, 1e-5);
  settings.air_viscosity = 2e-5;
  settings.skin = 1;
  Simulation simulation(settings, {});
  NewGrain grain;
  grain.velocity = {1, 0, 0};
  simulation.add_grains({grain});
  run_steps(simulation, 20000);
  const double rate = 7 * 6 * std::numbers::pi * 2e-5 * 7.84e-5 / 7.63e-8;
  EXPECT_NEAR(velocity_of(simulation, 0).x(), std::exp(-rate * simulation.time()), 1e-5);
  EXPECT_NEAR(1 / rate, 0.37, 0.005);  // OP-8
}

TEST(Ledger, AddedAndRemovedGrainsAreBooked) {
  const auto error = [](double time_step) {
    auto settings = weightless(Model::d, {.friction = 0.5}, time_step);
    settings.gravity = {0, 0, -9.81};
    Simulation simulation(settings, {});
    const double size = 2 * half_size(settings.shape());
    simulation.add_grains(converging_cloud({2, 2, 2}, size, 0.2, 3));
    run_for(simulation, 2e-4);
    simulation.add_grains(converging_cloud({2, 2, 1}, size, 0.2, 4, {0, 0, 2 * size}));
    run_for(simulation, 2e-4);
    EXPECT_GT(simulation.touching_pairs(), 0U);
    simulation.remove_grains([](const Eigen::Vector3d& place) { return place.x() > 0; });
    EXPECT_EQ(simulation.grains().size(), 6U);
    run_for(simulation, 2e-4);
    return std::abs(energy_balance_error(simulation));
  };
  const double coarse = error(1e-6), fine = error(1e-7);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, 0.3 * coarse);
}

/// A lone clump of four spheres with three different moments, turning for `steps`.
struct FreeTop {
  double energy_change, momentum_change, worst_norm;
};

FreeTop spin_freely(double time_step, int steps) {
  SimulationSettings settings = weightless(Model::d, {}, time_step);
  const double r = 1e-4;
  settings.shape() =
      rigid_grain(r, {{0, 0, 0}, {1.8 * r, 0, 0}, {0.4 * r, 1.5 * r, 0.2 * r}, {3 * r, -0.7 * r, 1.1 * r}},
                  7e-8, 1.5e-11);
  settings.skin = 1;
  Simulation simulation(settings, {});
  NewGrain grain;
  grain.orientation = {0.5, 0.1, -0.7, 0.3};
  grain.angular_velocity = {90, -60, 120};
  simulation.add_grains({grain});
  const double energy = energy_of(simulation).rotation;
  const Eigen::Vector3d before = angular_momentum(simulation);
  FreeTop top{0, 0, 0};
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    top.worst_norm = std::max(top.worst_norm, std::abs(simulation.grains().orientation_of(0).norm() - 1));
  }
  top.energy_change = std::abs(energy_of(simulation).rotation - energy) / energy;
  top.momentum_change = (angular_momentum(simulation) - before).norm() / before.norm();
  return top;
}

TEST(FreeTop, AsymmetricClumpKeepsEnergyAngularMomentumAndNorm) {
  const FreeTop top = spin_freely(2e-6, 100000);
  EXPECT_LT(top.energy_change, 1e-7);
  EXPECT_LT(top.momentum_change, 1e-5);
  EXPECT_LT(top.worst_norm, 1e-13);
}

TEST(FreeTop, ErrorsFallWithTheSquareOfTheStep) {
  const FreeTop coarse = spin_freely(2e-5, 10000), fine = spin_freely(1e-5, 20000);
  EXPECT_NEAR(std::log2(coarse.momentum_change / fine.momentum_change), 2, 0.1);
}

TEST(FreeTop, SymmetricTopPrecessesAboutItsAngularMomentum) {
  SimulationSettings settings = weightless(Model::d, {}, 2e-6);
  const double r = 1e-4;
  settings.types = {{rigid_grain(r, {{0, 0, -r}, {0, 0, r}}, 7e-8, 8e-12)}};
  ASSERT_NEAR(settings.shape().inertia.x(), settings.shape().inertia.y(),
              1e-12 * settings.shape().inertia.x());
  settings.skin = 1;
  Simulation simulation(settings, {});
  NewGrain grain;
  grain.angular_velocity = {150, 0, 400};
  simulation.add_grains({grain});
  const Eigen::Vector3d turning = angular_momentum(simulation);
  const double rate = turning.norm() / settings.shape().inertia.x();
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  run_steps(simulation, 40000);
  const Eigen::Vector3d expected = Eigen::AngleAxisd(rate * simulation.time(), turning.normalized()) * axis;
  const Eigen::Vector3d found = rotation_matrix(simulation.grains().orientation_of(0)).col(2);
  EXPECT_LT((found - expected).norm(), 1e-5);
  EXPECT_GT(rate * simulation.time(), 2 * std::numbers::pi);
}

}  // namespace
}  // namespace diefill::engine
