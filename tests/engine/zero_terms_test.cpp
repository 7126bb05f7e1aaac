// Terms with coefficients of zero, left out or computed: they come to nothing.
#include <gtest/gtest.h>

#include "engine_test_support.h"

namespace diefill::engine {
namespace {

/// A cloud of grains that falls onto a plate and collapses.
Simulation collapse(Model model, const Powder& powder, ZeroTerms terms, ZeroTerms rotation) {
  auto settings = weightless(model, powder, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.zero_terms = terms;
  settings.rotation_of_fixed_grains = rotation;
  const double size = 2 * half_size(settings.shape);
  Simulation simulation(settings, {plate(6 * size, 1.5e-4)});
  simulation.add_grains(converging_cloud({4, 4, 4}, 1.1 * size, 0.3, 9, {0, 0, 2.5 * size}));
  run_steps(simulation, 3000);
  return simulation;
}

class ZeroTermsOf : public ::testing::TestWithParam<std::tuple<Model, Powder>> {};

TEST_P(ZeroTermsOf, ComeToNothing) {
  const auto [model, powder] = GetParam();
  const auto without = collapse(model, powder, ZeroTerms::left_out, ZeroTerms::left_out);
  const auto with = collapse(model, powder, ZeroTerms::computed, ZeroTerms::computed);
  EXPECT_LT(without.ledger().viscous_work, 0) << "they have met";
  EXPECT_EQ(with.touching_pairs(), without.touching_pairs());
  for (std::uint64_t id = 0; id < without.grains().size(); ++id) {
    EXPECT_LT((position_of(with, id) - position_of(without, id)).norm(), 1e-15) << id;
    EXPECT_LT((velocity_of(with, id) - velocity_of(without, id)).norm(), 1e-12) << id;
  }
  EXPECT_EQ(with.ledger().tangential_work, without.ledger().tangential_work);
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

TEST(RotationOfFixedGrains, IsComputedAndTurnsNothing) {
  const Powder rough{.friction = 0.8};
  const auto fixed = collapse(Model::a, rough, ZeroTerms::left_out, ZeroTerms::left_out);
  const auto turning = collapse(Model::a, rough, ZeroTerms::left_out, ZeroTerms::computed);
  EXPECT_FALSE(fixed.kinds().rotates());
  EXPECT_TRUE(turning.kinds().rotates());
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
