// Periodic borders: grains go round, meet across the border and feel nothing of it.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kPeriod = 2.4e-3;  // m

SimulationSettings in_box(Model model, double time_step) {
  auto settings = weightless(model, {.friction = 0.5}, time_step);
  settings.period = {kPeriod, kPeriod};
  return settings;
}

TEST(Periodic, LoneGrainComesRoundAtItsSpeed) {
  Simulation simulation(in_box(Model::d, 1e-5), {});
  NewGrain grain;
  grain.velocity = {1, -0.7, 0.1};
  grain.angular_velocity = {10, 20, 30};
  simulation.add_grains({grain});
  run_steps(simulation, 1000);
  const PeriodicBox box(simulation.settings().period);
  const Eigen::Vector3d expected = grain.velocity * simulation.time();
  EXPECT_LT(box.wrapped(position_of(simulation, 0) - expected).norm(), 1e-14);
  EXPECT_LT((velocity_of(simulation, 0) - grain.velocity).norm(), 1e-15);
}

TEST(Periodic, WatchIsToldOfEveryGrainThatIsPutBack) {
  Simulation simulation(in_box(Model::d, 1e-5), {});
  NewGrain grain;
  grain.velocity = {1, 0, 0};
  simulation.add_grains({grain});
  double put_back = 0;  // m
  simulation.watch_borders([&](std::size_t k, const Eigen::Vector3d& before, const Eigen::Vector3d& now) {
    EXPECT_EQ(k, 0U);
    put_back += before.x() - now.x();
  });
  run_steps(simulation, 1000);
  EXPECT_GT(put_back, kPeriod);
  EXPECT_NEAR(std::remainder(put_back, kPeriod), 0, 1e-15);
  EXPECT_NEAR(position_of(simulation, 0).x() + put_back, simulation.time(), 1e-12);
}

/// End state of two grains that collide obliquely, seen from a frame shifted by `shift`.
std::pair<Eigen::Vector3d, Eigen::Vector3d> shifted_collision(const Eigen::Vector3d& shift) {
  Simulation simulation(in_box(Model::d, 1e-7), {});
  NewGrain left, right;
  left.position = shift + Eigen::Vector3d(-2.42e-4, 0, 0);
  left.velocity = {0.1, 0.02, 0};
  right.position = shift + Eigen::Vector3d(2.42e-4, 3e-5, 1e-5);
  right.velocity = {-0.1, 0, 0};
  right.orientation = {1, 0.1, 0.05, 0};
  simulation.add_grains({left, right});
  run_steps(simulation, 3000);
  EXPECT_LT(simulation.ledger().viscous_work, 0);
  return {velocity_of(simulation, 0), velocity_of(simulation, 1)};
}

TEST(Periodic, CollisionAcrossTheBorderIsTheSameCollision) {
  const auto inside = shifted_collision(Eigen::Vector3d::Zero());
  for (const Eigen::Vector3d& shift :
       {Eigen::Vector3d(0.5 * kPeriod, 0, 0), Eigen::Vector3d(0, 0.5 * kPeriod, 0),
        Eigen::Vector3d(0.5 * kPeriod, -0.5 * kPeriod, 0)}) {
    const auto across = shifted_collision(shift);
    EXPECT_LT((across.first - inside.first).norm(), 1e-10);
    EXPECT_LT((across.second - inside.second).norm(), 1e-10);
  }
}

TEST(Periodic, MomentumOfACloudStaysToRounding) {
  for (const Model model : {Model::b, Model::d}) {
    Simulation simulation(in_box(model, 2e-6), {});
    const double size = 2 * half_size(simulation.settings().shape());
    auto cloud = converging_cloud({5, 5, 3}, kPeriod / 5, 0.5, 6);
    for (auto& grain : cloud) grain.velocity += Eigen::Vector3d(0.4, 0.2, 0);
    simulation.add_grains(cloud);
    const Eigen::Vector3d before = momentum(simulation);
    run_steps(simulation, 1500);
    EXPECT_LT(simulation.ledger().viscous_work, 0);
    EXPECT_LT((momentum(simulation) - before).norm(), 1e-13 * before.norm()) << size;
  }
}

/// Speed of separation of two grains that meet across the border while all drift at `drift` (m/s) along x,
/// after a third one has been taken out on the way. `order`: which of the two is added first.
Eigen::Vector3d separation_after_removal(double drift, int order) {
  Simulation simulation(in_box(Model::d, 1e-6), {});
  NewGrain left, right, leaving;
  left.position = {0.5 * kPeriod - 2.42e-4, 0, 0};
  left.velocity = {0.05 + drift, 0, 0};
  right.position = {-0.5 * kPeriod + 2.42e-4, 3e-5, 1e-5};
  right.velocity = {-0.05 + drift, 0, 0};
  leaving.position = {0, 0, 2e-3};
  leaving.velocity.x() = drift;
  if (order == 0)
    simulation.add_grains({left, right, leaving});
  else
    simulation.add_grains({right, left, leaving});
  run_steps(simulation, 60);
  simulation.remove_grains([](const Eigen::Vector3d& place) { return place.z() > 1e-3; });
  EXPECT_EQ(simulation.grains().size(), 2U);
  run_steps(simulation, 600);
  const auto first = static_cast<std::uint64_t>(order);
  return velocity_of(simulation, 1 - first) - velocity_of(simulation, first);
}

TEST(Periodic, PowderDriftingFarLosesNoContactWhenGrainsLeave) {
  // The list ages by motion against the mean drift only: grains may be whole periods away from the box when
  // one of them is taken out.
  for (const int order : {0, 1}) {
    const Eigen::Vector3d static_normal = separation_after_removal(0, order);
    EXPECT_GT(static_normal.x(), 0.01);
    for (const double drift : {-20.0, 10.0, 20.0, 30.0})
      EXPECT_LT((separation_after_removal(drift, order) - static_normal).norm(), 1e-6) << drift;
  }
}

TEST(Periodic, FallingAlongAPeriodicAxisKeepsTheLedger) {
  auto settings = in_box(Model::a, 1e-5);
  settings.gravity = {5, 0, -5};
  Simulation simulation(settings, {});
  NewGrain grain;
  grain.velocity = {0.1, 0, 0};
  simulation.add_grains({grain, NewGrain{{0, 0, 1e-3}, {0, 0, 0.3}}});
  run_steps(simulation, 4000);
  EXPECT_LT(std::abs(energy_balance_error(simulation)), 1e-6);
}

TEST(Periodic, RefusesABoxThatGrainsWouldMeetThemselvesIn) {
  auto settings = in_box(Model::d, 1e-6);
  settings.period[1] = 1.9 * 4.7e-4;
  EXPECT_THROW(Simulation(settings, {}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
