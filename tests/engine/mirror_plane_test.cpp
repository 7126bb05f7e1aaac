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

TEST(WallContact, OfABodyItselfHoldsForThatBodyAlone) {
  auto settings = weightless(Model::a, {.friction = 0.5}, 1e-6);
  settings.gravity = {0, 0, -9.81};
  auto rough = plate(1e-3, 1.5e-4), smooth = rough;
  for (auto& centre : smooth.centres) centre.x() += 1e-2;
  smooth.contact = settings.wall_contact;
  smooth.contact->friction = 0;
  Simulation simulation(settings, {rough, smooth});
  NewGrain left, right;
  left.position.z() = right.position.z() = half_size(settings.shape);
  right.position.x() = 1e-2;
  left.position.y() = right.position.y() = 0.8 * 1.5e-4;
  simulation.add_grains({left, right});
  run_steps(simulation, 20000);
  // Both lie in a hollow of their plates by now; pushed along a row, only the rough plate resists.
  EXPECT_GT(simulation.wall_load(0).force.norm(), 0);
  EXPECT_NEAR(simulation.wall_load(1).force.z(), -settings.shape.mass * 9.81, 1e-2 * settings.shape.mass * 9.81);
  settings.general_contact.emplace();
  EXPECT_THROW(Simulation(settings, {rough, smooth}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
