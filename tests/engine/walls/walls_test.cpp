// Tools: what they carry, how they drag, what they cost (Bierwisch 2009, section 2.3; OP-5).
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

SimulationSettings heavy(Model model, double time_step) {
  auto settings = weightless(model, {}, time_step);
  settings.gravity = {0, 0, -9.81};
  return settings;
}

TEST(Walls, CarryTheWeightOfWhatRestsOnThem) {
  const auto settings = heavy(Model::d, 2e-6);
  Simulation simulation(settings, {plate(3e-3, 1.5e-4)});
  std::vector<NewGrain> grains;
  for (int k = 0; k < 5; ++k) {
    NewGrain grain;
    grain.position = {(k - 2) * 7e-4, 0, 2.6e-4};
    grains.push_back(grain);
  }
  simulation.add_grains(grains);
  run_steps(simulation, 100000);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int k = 0; k < 2000; ++k) {
    simulation.step();
    mean += simulation.wall_load(0).force / 2000;
  }
  const double weight = 5 * settings.shape().mass * 9.81;
  EXPECT_NEAR(mean.z(), -weight, 1e-3 * weight);
}

TEST(Walls, RestingSphereSinksInAsHertzSaysWithMixedRadius) {
  const auto settings = heavy(Model::a, 2e-6);
  const double wall_radius = 1e-3;
  WallBodySpec ball;
  ball.sphere_radius = wall_radius;
  ball.centres = {{0, 0, -wall_radius}};
  Simulation simulation(settings, {ball});
  NewGrain grain;
  grain.position.z() = settings.shape().sphere_radius;
  simulation.add_grains({grain});
  run_steps(simulation, 40000);
  const double effective = effective_radius(settings.shape().sphere_radius, wall_radius);
  const double expected =
      std::pow(settings.shape().mass * 9.81 / (2.0 / 3.0 * 1e7 * std::sqrt(effective)), 2.0 / 3.0);
  EXPECT_NEAR(simulation.deepest_overlap(), expected, 1e-6 * expected);
}

TEST(Walls, DampWithThePowdersAbsoluteCoefficient) {
  // A sphere that flies through the surface of a big wall sphere: one step's force is Hertz + damping with
  // gamma_n of the powder and R_eff of both radii (OP-5).
  const auto settings = weightless(Model::a, {}, 1e-9);
  const double wall_radius = 4.5e-4, radius = settings.shape().sphere_radius;
  WallBodySpec ball;
  ball.sphere_radius = wall_radius;
  ball.centres = {Eigen::Vector3d::Zero()};
  Simulation simulation(settings, {ball});
  NewGrain grain;
  const double overlap = 1e-6, speed = 0.1;
  grain.position = {0, 0, radius + wall_radius - overlap};
  grain.velocity = {0, 0, -speed};
  simulation.add_grains({grain});
  simulation.step();
  const double h = radius + wall_radius - position_of(simulation, 0).norm();
  const double effective = effective_radius(radius, wall_radius);
  const double expected = 2.0 / 3.0 * 1e7 * std::sqrt(effective) * std::pow(h, 1.5) +
                          1e6 * radius * std::sqrt(effective * h) * speed;
  EXPECT_NEAR(-simulation.wall_load(0).force.z(), expected, 1e-9 * expected);
}

TEST(Walls, MovingPlateDragsByFrictionUntilTheGrainMovesAlong) {
  auto settings = heavy(Model::a, 2e-6);
  const double speed = 0.05, friction = wall_contact(settings).friction;
  Simulation simulation(settings, {plane_wall([speed](double time) {
                          BodyMotion motion;
                          motion.velocity = {speed, 0, 0};
                          motion.translation = motion.velocity * time;
                          return motion;
                        })});
  NewGrain grain;
  grain.position.z() = settings.shape().sphere_radius - 4.4e-8;
  simulation.add_grains({grain});
  const double catch_up = speed / (friction * 9.81);
  while (simulation.time() < 0.5 * catch_up) simulation.step();
  EXPECT_NEAR(velocity_of(simulation, 0).x(), friction * 9.81 * simulation.time(), 5e-3 * speed);
  EXPECT_NEAR(simulation.wall_load(0).force.x(), -friction * settings.shape().mass * 9.81,
              1e-3 * settings.shape().mass);
  while (simulation.time() < 2 * catch_up) simulation.step();
  double mean = 0;
  for (int k = 0; k < 5000; ++k) {
    simulation.step();
    mean += velocity_of(simulation, 0).x() / 5000;
  }
  EXPECT_NEAR(mean, speed, 1e-2 * speed);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-3);
}

TEST(Walls, RotatingBodyMovesEachPointAtItsOwnSpeed) {
  BodyMotion motion;
  motion.translation = {1, 0, 0};
  motion.velocity = {0, 2, 0};
  motion.angular_velocity = {0, 0, 3};
  EXPECT_LT((motion.velocity_at({1, 4, 0}) - Eigen::Vector3d(-12, 2, 0)).norm(), 1e-14);
}

TEST(Walls, TurntableDragsAlongItsCircumference) {
  // Frictional load on a grain held by inertia in the first steps: force along omega x r.
  auto settings = heavy(Model::a, 1e-7);
  const double rate = 20;
  WallBodySpec table = plate(2e-3, 1.5e-4, [rate](double time) {
    BodyMotion motion;
    motion.angular_velocity = {0, 0, rate};
    motion.rotation = Eigen::AngleAxisd(rate * time, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return motion;
  });
  Simulation simulation(settings, {table});
  NewGrain grain;
  grain.position = {4 * 2.4e-4, 0, settings.shape().sphere_radius - 1e-7};
  simulation.add_grains({grain});
  run_steps(simulation, 20);
  const auto& load = simulation.wall_load(0);
  const Eigen::Vector3d on_grain = -load.force;
  EXPECT_GT(on_grain.y(), 0);
  EXPECT_LT(std::abs(on_grain.x()), 1e-2 * on_grain.y());
  // Torque about the frame's origin, from the contact point.
  const Eigen::Vector3d contact = grain.position - Eigen::Vector3d(0, 0, settings.shape().sphere_radius);
  EXPECT_NEAR(load.torque.z(), contact.cross(load.force).z(), 1e-3 * std::abs(load.torque.z()));
}

TEST(Walls, FarBodyCostsNoPairs) {
  const auto settings = heavy(Model::d, 2e-6);
  WallBodySpec far = plate(3e-3, 1.5e-4);
  for (auto& centre : far.centres) centre.z() -= 0.01;
  Simulation simulation(settings, {far, plate(3e-3, 1.5e-4)});
  NewGrain grain;
  grain.position.z() = 2.4e-4;
  simulation.add_grains({grain});
  std::size_t near_pairs = 0;
  for (const auto& block : simulation.neighbours().blocks()) {
    EXPECT_EQ(block.wall_first[0], block.wall_first[1]);
    near_pairs += block.wall_first[2] - block.wall_first[1];
  }
  EXPECT_GT(near_pairs, 0U);
  EXPECT_LT(near_pairs, 200U);
}

TEST(Walls, FastToolIsFoundBeforeItHits) {
  // A plate comes from far away at 0.5 m/s towards a grain at rest; the list must renew in time.
  auto settings = weightless(Model::d, {.damping_over_radius = 0}, 1e-7);
  Simulation simulation(settings, {plate(2e-3, 1.5e-4, [](double time) {
                          BodyMotion motion;
                          motion.velocity = {0, 0, 0.5};
                          motion.translation = {0, 0, -3e-3 + 0.5 * time};
                          return motion;
                        })});
  simulation.add_grains({NewGrain{}});
  double deepest = 0;
  while (simulation.time() < 8e-3 && velocity_of(simulation, 0).z() < 0.9) {
    simulation.step();
    deepest = std::max(deepest, simulation.deepest_overlap());
  }
  // A light grain leaves a heavy tool at up to twice the tool's speed, having dipped in as far as its energy
  // goes.
  EXPECT_GT(velocity_of(simulation, 0).z(), 0.1);
  EXPECT_GT(deepest, 0);
  EXPECT_LT(deepest, 0.25 * settings.shape().sphere_radius);
  EXPECT_LT(simulation.searches(), 300U);
}

TEST(Walls, EveryWallSphereInReachIsFound) {
  std::mt19937_64 random(9);
  WallBodySpec spec;
  spec.sphere_radius = 1e-4;
  for (int k = 0; k < 500; ++k) spec.centres.push_back(random_vector(random, 2e-3));
  const double reach = 4e-4;
  const WallBody body(spec, reach);
  ASSERT_EQ(body.size(), 500U);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector3d point = random_vector(random, 3e-3);
    std::vector<std::uint32_t> found;
    body.find(point, reach, found);
    std::size_t expected = 0;
    for (const auto& centre : body.centres()) expected += (centre - point).norm() < reach;
    EXPECT_EQ(found.size(), expected);
    for (const auto w : found) EXPECT_LT((body.centres()[w] - point).norm(), reach);
  }
}

TEST(Walls, NewMotionTakesOverFromNowOn) {
  auto settings = weightless(Model::a, {}, 1e-6);
  Simulation simulation(settings, {plate(1e-3, 1.5e-4)});
  EXPECT_FALSE(simulation.bodies()[0].moves());
  run_steps(simulation, 10);
  simulation.set_motion(0, [](double time) {
    BodyMotion motion;
    motion.translation.x() = time;
    motion.velocity.x() = 1;
    return motion;
  });
  EXPECT_DOUBLE_EQ(simulation.body_motion(0).translation.x(), 1e-5);
  simulation.step();
  EXPECT_DOUBLE_EQ(simulation.body_motion(0).translation.x(), 1.1e-5);
}

}  // namespace
}  // namespace diefill::engine
