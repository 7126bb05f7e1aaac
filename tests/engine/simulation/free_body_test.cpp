// Wall bodies that move by the forces on them: closed forms, conservation, stops, guides, and the same bits
// on any number of threads and after a restart.
#include <gtest/gtest.h>

#include "engine/simulation/free_bodies.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kBallRadius = 1.5e-4;  // m

/// A ball of one wall sphere, off the origin of its frame.
WallBodySpec ball(const Eigen::Vector3d& centre) {
  WallBodySpec spec;
  spec.name = "ball";
  spec.centres = {centre};
  spec.sphere_radius = kBallRadius;
  return spec;
}

FreeBodySpec free_ball(const Eigen::Vector3d& centre, double mass) {
  FreeBodySpec spec;
  spec.mass = mass;
  spec.centre = centre;
  spec.inertia = 0.4 * mass * kBallRadius * kBallRadius * Eigen::Matrix3d::Identity();
  return spec;
}

/// A simulation with one free body.
struct FreeRun {
  Simulation simulation;
  FreeBodies bodies;

  FreeRun(const SimulationSettings& settings, const WallBodySpec& wall) : simulation(settings, {wall}) {}
  void step() {
    bodies.before_step(simulation);
    simulation.step();
    bodies.after_step(simulation);
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  const FreeBody& body() const { return *bodies.of(0); }
};

SimulationSettings under_gravity(double time_step) {
  auto settings = weightless(Model::b, {}, time_step);
  settings.gravity = {0, 0, -9.81};
  return settings;
}

Eigen::Vector3d momentum_of(const FreeRun& run) {
  Eigen::Vector3d momentum = run.body().spec.mass * run.body().velocity;
  for (std::size_t k = 0; k < run.simulation.grains().size(); ++k)
    momentum += run.simulation.shape_of(k).mass * run.simulation.grains().velocity[k];
  return momentum;
}

/// About the origin.
Eigen::Vector3d angular_momentum_of(const FreeRun& run) {
  const FreeBody& body = run.body();
  Eigen::Vector3d sum = body.position.cross(body.spec.mass * body.velocity) +
                        rotation_matrix(body.orientation) * body.principal_inertia.cwiseProduct(body.spin);
  const Grains& grains = run.simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const GrainShape& shape = run.simulation.shape_of(k);
    sum += grains.position[k].cross(shape.mass * grains.velocity[k]) +
           rotation_matrix(grains.orientation_of(k)) * shape.inertia.cwiseProduct(grains.spin[k]);
  }
  return sum;
}

TEST(FreeBody, FallsFreelyAsTheClosedFormSays) {
  const Eigen::Vector3d centre(0.01, 0.02, 0.03);
  FreeRun run(under_gravity(1e-5), ball(centre));
  FreeBodySpec spec = free_ball(centre, 1e-3);
  spec.velocity = {0.5, 0, 1};
  spec.drive = {0, 2e-3, 0};
  run.bodies.release(spec, run.simulation);
  run.run(5000);
  const double t = run.simulation.time();
  const Eigen::Vector3d expected =
      centre + spec.velocity * t + 0.5 * t * t * Eigen::Vector3d(0, 2e-3 / 1e-3, -9.81);
  EXPECT_NEAR((run.body().position - expected).norm(), 0, 1e-13);
  EXPECT_NEAR((run.simulation.body_motion(0).point(centre) - expected).norm(), 0, 1e-13);
  EXPECT_NEAR(run.body().velocity.z(), 1 - 9.81 * t, 1e-12);
}

TEST(FreeBody, TurnsFreelyWithConstantEnergyAndAngularMomentum) {
  FreeRun run(weightless(Model::b, {}, 1e-5), ball({0, 0, 0.01}));
  FreeBodySpec spec = free_ball({0, 0, 0.01}, 1e-3);
  spec.inertia = Eigen::Vector3d(1e-9, 2e-9, 2.7e-9).asDiagonal();
  // About the middle axis, so that it tumbles.
  spec.angular_velocity = {1, 200, 1};
  run.bodies.release(spec, run.simulation);
  const double energy = run.body().kinetic_energy();
  const Eigen::Vector3d turning = angular_momentum_of(run);
  run.run(20000);
  EXPECT_NEAR(run.body().kinetic_energy(), energy, 1e-5 * energy);
  EXPECT_NEAR((angular_momentum_of(run) - turning).norm(), 0, 1e-5 * turning.norm());
  EXPECT_GT((run.body().spin - spec.angular_velocity).norm(), 10) << "it has not tumbled";
}

TEST(FreeBody, HitsAGrainElasticallyAsTwoMassesDo) {
  auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1e-7);
  const double grain_mass = settings.shape().mass, mass = 5 * grain_mass, speed = 0.3;
  const Eigen::Vector3d centre(-4e-4, 0, 0);
  FreeRun run(settings, ball(centre));
  run.simulation.add_grains({NewGrain{}});
  FreeBodySpec spec = free_ball(centre, mass);
  spec.velocity = {speed, 0, 0};
  run.bodies.release(spec, run.simulation);
  const Eigen::Vector3d before = momentum_of(run);
  double farthest = 0;
  for (int k = 0; k < 10000; ++k) {
    run.step();
    farthest = std::max(farthest, (momentum_of(run) - before).norm());
  }
  EXPECT_LT(farthest, 1e-12 * before.norm());
  EXPECT_NEAR(run.body().velocity.x(), speed * (mass - grain_mass) / (mass + grain_mass), 1e-4 * speed);
  EXPECT_NEAR(velocity_of(run.simulation, 0).x(), speed * 2 * mass / (mass + grain_mass), 1e-4 * speed);
}

TEST(FreeBody, ObliqueCollisionWithFrictionConservesLinearAndAngularMomentum) {
  // Clumps: their lever arms end at the contact point, those of single spheres at the surface.
  auto settings = weightless(Model::d, {.friction = 0.5}, 1e-7);
  const Eigen::Vector3d centre(-5e-4, 1.2e-4, 0);
  FreeRun run(settings, ball(centre));
  NewGrain grain;
  grain.angular_velocity = {0, 30, 300};
  run.simulation.add_grains({grain});
  FreeBodySpec spec = free_ball(centre, 2 * settings.shape().mass);
  spec.velocity = {0.4, 0, 0.1};
  spec.angular_velocity = {0, 0, 500};
  run.bodies.release(spec, run.simulation);
  const Eigen::Vector3d momentum = momentum_of(run), turning = angular_momentum_of(run);
  run.run(10000);
  EXPECT_GT((run.body().velocity - spec.velocity).norm(), 0.05) << "they have missed each other";
  EXPECT_LT((momentum_of(run) - momentum).norm(), 1e-12 * momentum.norm());
  EXPECT_LT((angular_momentum_of(run) - turning).norm(), 1e-5 * turning.norm());
}

TEST(FreeBody, StaysOnItsGuideAndDoesNotTurn) {
  auto settings = weightless(Model::b, {.friction = 0.5}, 1e-7);
  settings.gravity = {3, 2, -9.81};
  FreeRun run(settings, ball({0, 1e-4, 4e-4}));
  run.simulation.add_grains({NewGrain{}});
  FreeBodySpec spec = free_ball({0, 1e-4, 4e-4}, settings.shape().mass);
  spec.guide = Eigen::Vector3d::UnitZ();
  spec.turns = false;
  spec.velocity = {0, 0, -0.5};
  run.bodies.release(spec, run.simulation);
  run.run(10000);
  EXPECT_GT(run.body().velocity.z(), -0.4) << "it has not met the grain";
  EXPECT_EQ(run.body().position.x(), 0);
  EXPECT_EQ(run.body().position.y(), 1e-4);
  EXPECT_EQ(run.simulation.body_motion(0).rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(run.simulation.body_motion(0).angular_velocity, Eigen::Vector3d::Zero());
}

TEST(FreeBody, BouncesOffItsStopAndRestsOnIt) {
  FreeRun run(under_gravity(1e-5), ball({0, 0, 0}));
  FreeBodySpec spec = free_ball({0, 0, 0}, 1e-3);
  spec.stops[0] = {-Eigen::Vector3d::UnitZ(), 0.02, 0.5};
  spec.stop_count = 1;
  run.bodies.release(spec, run.simulation);
  double lowest = 0, fastest_up = 0;
  for (int k = 0; k < 40000; ++k) {
    run.step();
    lowest = std::min(lowest, run.body().position.z());
    fastest_up = std::max(fastest_up, run.body().velocity.z());
  }
  EXPECT_NEAR(lowest, -0.02, 1e-15);
  EXPECT_NEAR(fastest_up, 0.5 * std::sqrt(2 * 9.81 * 0.02), 1e-3);
  EXPECT_NEAR(run.body().position.z(), -0.02, 1e-8);
  EXPECT_NEAR(run.body().velocity.z(), 0, 1e-3);
}

TEST(FreeBody, IsHeldWhereItIs) {
  FreeRun run(under_gravity(1e-5), ball({0, 0, 0}));
  run.bodies.release(free_ball({0, 0, 0}, 1e-3), run.simulation);
  run.run(1000);
  const double height = run.body().position.z();
  run.bodies.hold(0, run.simulation);
  run.run(1000);
  EXPECT_EQ(run.body().position.z(), height);
  EXPECT_EQ(run.simulation.body_motion(0).velocity, Eigen::Vector3d::Zero());
}

/// A ball amid a cloud of grains that fall together.
FreeRun ball_in_cloud(int threads) {
  auto settings = weightless(Model::d, {.friction = 0.5, .work_of_adhesion = 0.01}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.threads = threads;
  return {settings, ball({0, 0, 0})};
}

void start(FreeRun& run) {
  const double size = 2 * half_size(run.simulation.settings().shape());
  auto cloud = converging_cloud({6, 6, 6}, size, 0.5, 21);
  std::erase_if(cloud, [&](const NewGrain& grain) { return grain.position.norm() < size; });
  run.simulation.add_grains(cloud);
  FreeBodySpec spec = free_ball({0, 0, 0}, 2 * run.simulation.settings().shape().mass);
  spec.velocity = {0.3, -0.2, 0.4};
  run.bodies.release(spec, run.simulation);
}

TEST(FreeBody, MovesTheSameOnAnyNumberOfThreads) {
  FreeRun one = ball_in_cloud(1), four = ball_in_cloud(4);
  start(one);
  start(four);
  one.run(800);
  four.run(800);
  EXPECT_NE(one.body().force, Eigen::Vector3d::Zero());
  EXPECT_EQ(one.simulation.hash(), four.simulation.hash());
  EXPECT_EQ(one.body().position, four.body().position);
  EXPECT_EQ(one.body().orientation, four.body().orientation);
  EXPECT_EQ(one.body().spin, four.body().spin);
}

TEST(FreeBody, GoesOnBitForBitAfterARestart) {
  FreeRun unbroken = ball_in_cloud(2), broken = ball_in_cloud(2), resumed = ball_in_cloud(2);
  start(unbroken);
  start(broken);
  unbroken.run(800);
  broken.run(400);
  resumed.bodies.restore(broken.bodies.state(), resumed.simulation);
  resumed.simulation.restore(broken.simulation.snapshot());
  EXPECT_EQ(resumed.simulation.body_motion(0).translation, broken.simulation.body_motion(0).translation);
  resumed.run(400);
  EXPECT_EQ(resumed.simulation.hash(), unbroken.simulation.hash());
  EXPECT_EQ(resumed.body().position, unbroken.body().position);
  EXPECT_EQ(resumed.body().velocity, unbroken.body().velocity);
  EXPECT_EQ(resumed.body().spin, unbroken.body().spin);
}

TEST(FreeBody, RefusesWhatCannotMove) {
  FreeRun run(under_gravity(1e-5), ball({0, 0, 0}));
  FreeBodySpec spec = free_ball({0, 0, 0}, 0);
  EXPECT_THROW(run.bodies.release(spec, run.simulation), std::invalid_argument);
  spec = free_ball({0, 0, 0}, 1e-3);
  spec.guide = {1, 1, 0};
  EXPECT_THROW(run.bodies.release(spec, run.simulation), std::invalid_argument);
  spec.guide = {1, 0, 0};
  spec.stops[0] = {Eigen::Vector3d::UnitZ(), 0.01, 0};
  spec.stop_count = 1;
  EXPECT_THROW(run.bodies.release(spec, run.simulation), std::invalid_argument);
  spec = free_ball({0, 0, 0}, 1e-3);
  spec.inertia.setZero();
  EXPECT_THROW(run.bodies.release(spec, run.simulation), std::invalid_argument);
  spec = free_ball({0, 0, 0}, 1e-3);
  spec.body = 1;
  EXPECT_THROW(run.bodies.release(spec, run.simulation), std::invalid_argument);
  spec.body = 0;
  run.bodies.release(spec, run.simulation);
  EXPECT_THROW(run.bodies.release(spec, run.simulation), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
