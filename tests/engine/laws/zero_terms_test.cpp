// Terms with coefficients of zero are left out of the loop over contacts: they would come to nothing.
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// A coefficient whose term is computed and comes to nothing.
constexpr double kNearlyNothing = 1e-200;

/// A cloud of grains that falls onto a plate and collapses.
Simulation collapse(SimulationSettings settings) {
  settings.gravity = {0, 0, -9.81};
  const double size = 2 * half_size(settings.shape());
  Simulation simulation(settings, {plate(6 * size, 1.5e-4)});
  auto grains = converging_cloud({4, 4, 4}, 1.1 * size, 0.3, 9, {0, 0, 2.5 * size});
  for (auto& grain : grains) grain.angular_velocity.setZero();
  simulation.add_grains(grains);
  run_steps(simulation, 3000);
  return simulation;
}

class ZeroTermsOf : public ::testing::TestWithParam<std::tuple<Model, Powder>> {};

TEST_P(ZeroTermsOf, WouldComeToNothing) {
  const auto [model, powder] = GetParam();
  auto settings = weightless(model, powder, 2e-6);
  const auto without = collapse(settings);
  for (const char* other : {kPowderMaterial, kWallMaterial}) {
    ContactAccess contact(settings, other);
    contact.friction = std::max(contact.friction, kNearlyNothing);
    contact.work_of_adhesion = std::max(contact.work_of_adhesion, kNearlyNothing);
  }
  const auto with = collapse(settings);
  EXPECT_LT(without.ledger().viscous_work, 0) << "they have met";
  EXPECT_EQ(with.touching_pairs(), without.touching_pairs());
  for (std::uint64_t id = 0; id < without.grains().size(); ++id) {
    EXPECT_LT((position_of(with, id) - position_of(without, id)).norm(), 1e-15) << id;
    EXPECT_LT((velocity_of(with, id) - velocity_of(without, id)).norm(), 1e-12) << id;
  }
  EXPECT_NEAR(with.ledger().tangential_work, without.ledger().tangential_work, 1e-100);
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<Model, Powder>>& instance) {
  static const char* const kNames[] = {"Smooth", "Rough", "Sticky", "Rolling", "Clumps"};
  return kNames[instance.index];
}

INSTANTIATE_TEST_SUITE_P(Grains, ZeroTermsOf,
                         ::testing::Values(std::tuple(Model::a, Powder{}),
                                           std::tuple(Model::a, Powder{.friction = 0.4}),
                                           std::tuple(Model::a, Powder{.work_of_adhesion = 0.01}),
                                           std::tuple(Model::b, Powder{.friction = 0.4}),
                                           std::tuple(Model::d, Powder{.friction = 0.4})),
                         name_of);

TEST(RotationOfFixedGrains, IsThatOfGrainsTooHeavyToTurn) {
  constexpr double kNothingTurnsIt = 1e30;
  auto settings = weightless(Model::a, {.friction = 0.8}, 2e-6);
  const auto fixed = collapse(settings);
  settings.shape().rotates = true;
  settings.shape().inertia *= kNothingTurnsIt;
  const auto turning = collapse(settings);
  EXPECT_FALSE(fixed.types().rotates());
  EXPECT_TRUE(turning.types().rotates());
  double torque = 0;
  for (std::size_t k = 0; k < turning.grains().size(); ++k) {
    torque = std::max(torque, turning.grains().torque[k].norm());
    EXPECT_LT(turning.angular_velocity(k).norm(), 1e-15) << "rad/s";
  }
  EXPECT_GT(torque, 1e-12) << "N m: friction would turn them";
  for (std::uint64_t id = 0; id < fixed.grains().size(); ++id)
    EXPECT_LT((position_of(turning, id) - position_of(fixed, id)).norm(), 1e-15) << id;
}

}  // namespace
}  // namespace diefill::engine
