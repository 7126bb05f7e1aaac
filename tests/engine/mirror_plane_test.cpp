// A mirror plane acts on a grain as the grain's own image behind it would.
#include <gtest/gtest.h>

#include "engine_test_support.h"

namespace diefill::engine {
namespace {

/// A plane at x = 0 with powder on the side of positive x.
WallBodySpec mirror_at_zero(const SimulationSettings& settings) {
  WallBodySpec mirror;
  mirror.name = "mirror plane";
  mirror.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  mirror.contact = mirror_plane(settings.grain_contact);
  return mirror;
}

NewGrain approaching(const SimulationSettings& settings, double side) {
  NewGrain grain;
  grain.position = {side * (half_size(settings.shape) + 1e-6), 0, 0};
  grain.velocity = {-side * 0.2, 0.05, 0};
  return grain;
}

class MirrorPlane : public ::testing::TestWithParam<std::tuple<Model, double>> {};

TEST_P(MirrorPlane, ReflectsAsTheImageWould) {
  const auto [model, adhesion] = GetParam();
  const auto settings = weightless(model, {.friction = 0.8, .work_of_adhesion = adhesion}, 1e-6);
  Simulation pair(settings, {}), half(settings, {mirror_at_zero(settings)});
  pair.add_grains({approaching(settings, 1), approaching(settings, -1)});
  half.add_grains({approaching(settings, 1)});
  double deepest = 0;
  for (int step = 0; step < 3000; ++step) {
    pair.step();
    half.step();
    deepest = std::max(deepest, half.deepest_overlap());
    ASSERT_LT((position_of(pair, 0) - position_of(half, 0)).norm(), 1e-9 * half_size(settings.shape)) << step;
  }
  EXPECT_GT(deepest, 1e-7) << "they have met";
  EXPECT_LT((velocity_of(pair, 0) - velocity_of(half, 0)).norm(), 1e-8);
  EXPECT_NEAR(velocity_of(half, 0).y(), 0.05, 1e-12) << "nothing holds what slides along the plane";
}

INSTANTIATE_TEST_SUITE_P(Grains, MirrorPlane,
                         ::testing::Combine(::testing::Values(Model::a, Model::b, Model::c, Model::d),
                                            ::testing::Values(0.0, 0.02)));

/// m/s, of a grain that set out at 0.05 m/s on a level plane 20 ms ago.
double speed_on_plane(std::optional<double> friction_of_plane) {
  auto settings = weightless(Model::a, {.friction = 0.5}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.wall_contact.friction = 0.15;
  WallBodySpec floor, far_away;
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  far_away.planes = {{Eigen::Vector3d(1, 0, 0), -Eigen::Vector3d::UnitX()}};
  if (friction_of_plane) {
    floor.contact = settings.wall_contact;
    floor.contact->friction = *friction_of_plane;
  }
  Simulation simulation(settings, {floor, far_away});
  NewGrain grain;
  grain.position.z() = half_size(settings.shape);
  grain.velocity.x() = 0.05;
  simulation.add_grains({grain});
  run_steps(simulation, 10000);
  return velocity_of(simulation, 0).x();
}

TEST(WallContact, OfABodyItselfHoldsForThatBody) {
  const double slowed = 9.81 * 0.02;
  EXPECT_NEAR(speed_on_plane({}), 0.05 - 0.15 * slowed, 1e-3);
  EXPECT_NEAR(speed_on_plane(0.05), 0.05 - 0.05 * slowed, 1e-3);
  EXPECT_NEAR(speed_on_plane(0), 0.05, 1e-9);
}

TEST(WallContact, OfABodyItselfIsRefusedBesideAGeneralLaw) {
  auto settings = weightless(Model::a, {}, 1e-6);
  settings.general_contact.emplace();
  EXPECT_THROW(Simulation(settings, {mirror_at_zero(settings)}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
