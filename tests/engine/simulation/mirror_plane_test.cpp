// A mirror plane acts on a grain as the grain's own image behind it would.
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine {
namespace {

/// A plane at x = 0 with powder on the side of positive x.
WallBodySpec mirror_at_zero() {
  WallBodySpec mirror;
  mirror.name = "mirror plane";
  mirror.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  mirror.mirror = true;
  return mirror;
}

NewGrain approaching(const SimulationSettings& settings, double side) {
  NewGrain grain;
  grain.position = {side * (half_size(settings.shape()) + 1e-6), 0, 0};
  grain.velocity = {-side * 0.2, 0.05, 0};
  return grain;
}

class MirrorPlane : public ::testing::TestWithParam<std::tuple<Model, double>> {};

TEST_P(MirrorPlane, ReflectsAsTheImageWould) {
  const auto [model, adhesion] = GetParam();
  const auto settings = weightless(model, {.friction = 0.8, .work_of_adhesion = adhesion}, 1e-6);
  Simulation pair(settings, {}), half(settings, {mirror_at_zero()});
  pair.add_grains({approaching(settings, 1), approaching(settings, -1)});
  half.add_grains({approaching(settings, 1)});
  double deepest = 0;
  for (int step = 0; step < 3000; ++step) {
    pair.step();
    half.step();
    deepest = std::max(deepest, half.deepest_overlap());
    ASSERT_LT((position_of(pair, 0) - position_of(half, 0)).norm(), 1e-9 * half_size(settings.shape()))
        << step;
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
  wall_contact(settings)->friction = 0.15;
  WallBodySpec floor, far_away;
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  far_away.planes = {{Eigen::Vector3d(1, 0, 0), -Eigen::Vector3d::UnitX()}};
  if (friction_of_plane) {
    floor.material = "polished";
    ContactParameters polished = wall_contact(settings);
    polished.friction = *friction_of_plane;
    settings.contact.pairs.push_back({kPowderMaterial, "polished", laws::bierwisch_law(polished)});
  }
  Simulation simulation(settings, {floor, far_away});
  NewGrain grain;
  grain.position.z() = half_size(settings.shape());
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

/// A sphere that comes at a slant and spins, and its image.
std::vector<NewGrain> spinning_pair(double radius, double gap) {
  std::vector<NewGrain> grains(2);
  for (const double side : {1.0, -1.0}) {
    NewGrain& grain = grains[side > 0 ? 0 : 1];
    grain.position = {side * (radius + 0.5 * gap), 0, 0};
    grain.velocity = {-side * 0.2, 0.05, 0};
    grain.angular_velocity = {30, side * 20, side * -10};
  }
  return grains;
}

class MirrorPlaneUnder : public ::testing::TestWithParam<laws::NamedLaw> {};

TEST_P(MirrorPlaneUnder, AnyLawReflectsAsTheImageWould) {
  auto settings = weightless(Model::b, {}, 2e-8);
  settings.contact = GeneralContact{GetParam().law, {}};
  const double radius = settings.shape().sphere_radius;
  const double range = laws::make_law(GetParam().law, {radius, radius, 1, 1}).range();
  const auto grains = spinning_pair(radius, 1.01 * range + 1e-8);
  Simulation pair(settings, {}), half(settings, {mirror_at_zero()});
  pair.add_grains(grains);
  half.add_grains({grains[0]});
  const auto approach = static_cast<int>(1.01 * range / 0.4 / settings.time_step);
  for (int step = 0; step < approach + 3000; ++step) {
    pair.step();
    half.step();
  }
  EXPECT_GT(half.deepest_overlap_of_run(), 1e-8) << "they have met";
  EXPECT_LT((position_of(pair, 0) - position_of(half, 0)).norm(), 1e-9 * radius);
  EXPECT_LT((velocity_of(pair, 0) - velocity_of(half, 0)).norm(), 1e-8);
  EXPECT_LT((pair.angular_velocity(place_of(pair, 0)) - half.angular_velocity(0)).norm(), 1e-6);
  EXPECT_NEAR(pair.ledger().viscous_work, 2 * half.ledger().viscous_work,
              1e-9 * std::abs(pair.ledger().viscous_work) + 1e-20);
}

INSTANTIATE_TEST_SUITE_P(Sources, MirrorPlaneUnder, ::testing::ValuesIn(laws::laws_of_the_sources()),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           for (char& letter : name)
                             if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace diefill::engine
