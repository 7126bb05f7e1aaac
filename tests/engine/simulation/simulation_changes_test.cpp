// What changes while a simulation runs: gravity, laws and velocities; and powders whose types differ in
// shape.
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "engine/observe/powder_figures.h"
#include "engine/powder/clump_union.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// A few grains that fly at each other over a floor.
Simulation cloud(const SimulationSettings& settings) {
  const double size = 2 * half_size(settings.shape());
  Simulation simulation(settings, {plane_wall()});
  simulation.add_grains(converging_cloud({3, 3, 3}, size, 0.3, 4, {0, 0, 2 * size}));
  return simulation;
}

double balance_error(const Simulation& simulation) {
  return std::abs(energy_balance_error(simulation));
}

TEST(SimulationChanges, GravityIsThatOfASimulationThatBeganWithIt) {
  auto settings = weightless(Model::d, {.friction = 0.5}, 1e-6);
  auto falling = settings;
  falling.gravity = {1, 0, -9.81};
  Simulation late = cloud(settings), early = cloud(falling);
  late.set_gravity(falling.gravity);
  run_steps(late, 300);
  run_steps(early, 300);
  for (std::uint64_t id = 0; id < 27; ++id) {
    EXPECT_LT((position_of(late, id) - position_of(early, id)).norm(), 1e-15) << id;
    EXPECT_LT((velocity_of(late, id) - velocity_of(early, id)).norm(), 1e-12) << id;
  }
}

TEST(SimulationChanges, BalanceEnergy) {
  for (const auto model : {Model::b, Model::d}) {
    auto settings = weightless(model, {.friction = 0.5}, 2.5e-7);
    Simulation simulation = cloud(settings);
    run_steps(simulation, 1600);
    simulation.set_gravity({0, 0, -9.81});
    run_steps(simulation, 1600);
    grain_contact(settings)->friction = 0;
    wall_contact(settings)->work_of_adhesion = 0.01;
    simulation.set_contact(settings.contact);
    run_steps(simulation, 1600);
    simulation.add_velocities(
        [](std::uint64_t id) { return Eigen::Vector3d(0.1 * static_cast<double>(id % 3), 0, -0.05); });
    run_steps(simulation, 3200);
    EXPECT_LT(balance_error(simulation), 0.005);
  }
}

TEST(SimulationChanges, StoppedGrainsStayWhereTheyAre) {
  for (const auto model : {Model::b, Model::d}) {
    const auto settings = weightless(model, {.friction = 0.5}, 2.5e-7);
    const double size = 2 * half_size(settings.shape());
    Simulation simulation(settings, {plane_wall()});
    simulation.add_grains(converging_cloud({3, 3, 3}, 2 * size, 0.3, 4, {0, 0, 4 * size}));
    run_steps(simulation, 10);
    ASSERT_EQ(simulation.touching_pairs(), 0U);
    const Eigen::Vector3d place = position_of(simulation, 5);
    simulation.stop_grains();
    run_steps(simulation, 1000);
    EXPECT_EQ((position_of(simulation, 5) - place).norm(), 0);
    for (const auto& spin : simulation.grains().spin) EXPECT_EQ(spin.norm(), 0);
    EXPECT_LT(balance_error(simulation), 1e-9);
  }
}

TEST(SimulationChanges, StoppingGrainsInContactBalancesEnergy) {
  Simulation simulation = cloud(weightless(Model::d, {.friction = 0.5}, 2.5e-7));
  for (int n = 0; n < 20000 && simulation.touching_pairs() < 5; ++n) simulation.step();
  ASSERT_GE(simulation.touching_pairs(), 5U);
  simulation.stop_grains();
  run_steps(simulation, 3200);
  EXPECT_LT(balance_error(simulation), 0.005);
}

TEST(SimulationChanges, LawsPutBackChangeNoBitOfContactHistory) {
  auto settings = weightless(Model::d, {.friction = 0.5}, 1e-6);
  settings.gravity = {0, 0, -9.81};
  Simulation changed = cloud(settings), plain = cloud(settings);
  for (Simulation* simulation : {&changed, &plain}) run_steps(*simulation, 600);
  ASSERT_GT(plain.touching_pairs(), 5U);
  changed.set_contact(settings.contact);
  plain.set_contact(settings.contact);
  changed.set_contact(settings.contact);
  for (Simulation* simulation : {&changed, &plain}) run_steps(*simulation, 200);
  EXPECT_EQ(changed.hash(), plain.hash());
}

TEST(SimulationChanges, ARestartGoesOnBitForBit) {
  auto settings = weightless(Model::d, {.friction = 0.5}, 1e-6);
  Simulation simulation = cloud(settings);
  run_steps(simulation, 300);
  auto changed = settings;
  grain_contact(changed)->friction = 0.1;
  simulation.set_contact(changed.contact);
  simulation.set_gravity({0, 0, -5});
  run_steps(simulation, 300);
  Simulation resumed(settings, {plane_wall()});
  resumed.set_contact(changed.contact);
  resumed.set_gravity({0, 0, -5});
  resumed.restore(simulation.snapshot());
  for (Simulation* each : {&simulation, &resumed}) run_steps(*each, 300);
  EXPECT_EQ(simulation.hash(), resumed.hash());
}

/// Single spheres, clumps of seven, and a clump of unequal spheres, of one material.
SimulationSettings of_many_shapes() {
  auto settings = weightless(Model::d, {.friction = 0.5}, 5e-7);
  const double radius = 7.84e-5;
  settings.types.push_back({model_b(1.5e-4, 7.63e-8)});
  settings.types.push_back({grain_of_union({{{0, 0, 0}, 2 * radius}, {{2.2 * radius, 0, 0}, radius}}, 5400)});
  return settings;
}

TEST(ManyShapes, ConserveMomentumAndEnergy) {
  auto settings = of_many_shapes();
  Simulation simulation(settings, {});
  auto grains = converging_cloud({4, 4, 4}, 2 * half_size(settings.shape()), 0.4, 8);
  for (std::size_t k = 0; k < grains.size(); ++k) grains[k].kind = static_cast<TypeNumber>(k % 3);
  simulation.add_grains(grains);
  const auto momentum_now = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < simulation.grains().size(); ++k)
      sum += simulation.shape_of(k).mass * simulation.grains().velocity[k];
    return sum;
  };
  const auto turning_now = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Grains& all = simulation.grains();
    for (std::size_t k = 0; k < all.size(); ++k) {
      const GrainShape& shape = simulation.shape_of(k);
      sum += shape.mass * all.position[k].cross(all.velocity[k]);
      sum += rotation_matrix(all.orientation_of(k)) * shape.inertia.cwiseProduct(all.spin[k]);
    }
    return sum;
  };
  const Eigen::Vector3d before = momentum_now(), turning = turning_now();
  std::uint64_t touched = 0;
  for (int k = 0; k < 3000; ++k) {
    simulation.step();
    touched = std::max(touched, simulation.touching_pairs());
  }
  EXPECT_GT(touched, 20U);
  const double scale = 64 * 7.63e-8 * 0.4;
  EXPECT_LT((momentum_now() - before).norm(), 1e-12 * scale);
  EXPECT_LT((turning_now() - turning).norm(), 1e-6 * scale * half_size(settings.shape()));
  EXPECT_LT(balance_error(simulation), 0.01);
  EXPECT_EQ(sphere_count(simulation), 64U / 3 * 10 + 7);
}

TEST(ManyShapes, OneShapeGivenTwiceMovesAsItself) {
  const auto one = weightless(Model::d, {.friction = 0.5}, 1e-6);
  auto with_spheres = one;
  with_spheres.types.push_back({model_b(1.5e-4, 7.63e-8)});  // a type that no grain is of
  Simulation alone(one, {}), beside(with_spheres, {});
  for (Simulation* simulation : {&alone, &beside}) {
    simulation->add_grains(converging_cloud({3, 3, 3}, 2 * half_size(one.shape()), 0.3, 8));
    run_steps(*simulation, 400);
  }
  EXPECT_GT(alone.touching_pairs(), 10U);
  for (std::uint64_t id = 0; id < 27; ++id)
    EXPECT_LT((position_of(alone, id) - position_of(beside, id)).norm(), 1e-9 * half_size(one.shape())) << id;
}

TEST(ManyShapes, SpheresThatDoNotRotateStayUnturnedAmongThoseThatDo) {
  auto settings = weightless(Model::d, {.friction = 0.8}, 1e-6);
  settings.types.push_back({model_a(1.5e-4, 7.63e-8)});
  Simulation simulation(settings, {});
  auto grains = converging_cloud({3, 3, 3}, 2 * half_size(settings.shape()), 0.4, 8);
  for (std::size_t k = 0; k < grains.size(); k += 2) grains[k].kind = 1;
  simulation.add_grains(grains);
  run_steps(simulation, 1500);
  for (std::size_t k = 0; k < simulation.grains().size(); ++k) {
    if (simulation.grains().kind[k] != 1) continue;
    EXPECT_LT(simulation.angular_velocity(k).norm(), 1e-15) << k;
  }
}

TEST(PeriodicHeight, GrainsMeetAcrossIt) {
  // Two spheres, one near the top and one near the bottom, fly apart and meet through the border.
  auto settings = weightless(Model::b, {}, 1e-6);
  const double radius = settings.shape().sphere_radius, length = 12 * radius;
  settings.period = {length, length, length};
  Simulation simulation(settings, {});
  std::vector<NewGrain> grains(2);
  grains[0].position = {0, 0, 4 * radius};
  grains[0].velocity = {0, 0, 0.2};
  grains[1].position = {0, 0, -4 * radius};
  grains[1].velocity = {0, 0, -0.2};
  simulation.add_grains(grains);
  const double way = 4 * radius - 2 * radius;  // each, until they touch
  run_steps(simulation, static_cast<int>(way / 2 / 0.2 / 1e-6) + 3000);
  EXPECT_LT(velocity_of(simulation, 0).z(), -0.01) << "they have met and parted";
  EXPECT_NEAR(velocity_of(simulation, 0).z(), -velocity_of(simulation, 1).z(), 1e-12);
}

}  // namespace
}  // namespace diefill::engine
