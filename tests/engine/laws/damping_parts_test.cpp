// Restitution against impact speed for each damping.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

constexpr double kModulus = 5.5e6, kStiffness = 150;

/// s, a small part of Hertz' collision time at `speed` in m/s.
double hertz_step(const PairProperties& pair, double speed) {
  const double stiffness = 4.0 / 3.0 * kModulus * std::sqrt(pair.effective_radius());
  const double depth = std::pow(1.25 * pair.effective_mass() * speed * speed / stiffness, 0.4);
  return depth / speed / 4000;
}

TEST(RestitutionRatio, CoversAllOfItsRange) {
  EXPECT_EQ(restitution_damping_ratio(0), 1);
  EXPECT_EQ(restitution_damping_ratio(1), 0);
  EXPECT_NEAR(restitution_damping_ratio(std::exp(-std::numbers::pi)), std::sqrt(0.5), 1e-15);
  double before = 1;
  for (const double e : {1e-300, 1e-10, 0.1, 0.5, 0.9, 0.999}) {
    EXPECT_LT(restitution_damping_ratio(e), before);
    before = restitution_damping_ratio(e);
  }
}

class RestitutionGiven : public ::testing::TestWithParam<double> {};

TEST_P(RestitutionGiven, ComesBackFromHertzAtEverySpeedAndSize) {
  const LawParameters law{
      .normal = HertzMindlinNormal::Parameters{.modulus = kModulus},
      .damping = RestitutionDamping::Parameters{.restitution = GetParam(), .modulus = kModulus}};
  require_sensible(law);
  for (const auto& pair : {spheres(2.5e-4, 2.5e-4), spheres(2.5e-4, 1e-3), spheres(1e-3, 1e-3, 2500)})
    for (const double speed : {0.01, 0.1, 1.0})
      EXPECT_NEAR(collide(law, pair, speed, hertz_step(pair, speed)).restitution, GetParam(), 2e-3) << speed;
}

TEST_P(RestitutionGiven, ComesBackFromLinearSpringWithTheReducedMass) {
  const LawParameters law{
      .normal = LinearNormal::Parameters{.stiffness = kStiffness},
      .damping = LinearRestitutionDamping::Parameters{.restitution = GetParam(), .stiffness = kStiffness}};
  require_sensible(law);
  const auto pair = spheres(6e-5, 9e-5, 1545);
  const double period = std::numbers::pi * std::sqrt(pair.effective_mass() / kStiffness);
  for (const double speed : {0.01, 0.3}) {
    const auto outcome = collide(law, pair, speed, period / 10000);
    EXPECT_NEAR(outcome.restitution, GetParam(), 1e-3) << speed;
  }
}

INSTANTIATE_TEST_SUITE_P(Coefficients, RestitutionGiven, ::testing::Values(0.1, 0.5, 0.65, 0.9, 1.0));

TEST(LinearDamping, PrintedMassOfKottlanReturnsTooLittle) {
  // With 2 M instead of M the ratio grows by sqrt(2): 0.65 becomes 0.541 (Kottlan 2018, Eq. 8).
  const auto pair = spheres(6e-5, 6e-5, 1545);
  const double coefficient =
      2 * restitution_damping_ratio(0.65) * std::sqrt(2 * pair.effective_mass() * kStiffness);
  const LawParameters law{.normal = LinearNormal::Parameters{.stiffness = kStiffness},
                          .damping = ConstantDamping::Parameters{.coefficient = coefficient}};
  const double period = std::numbers::pi * std::sqrt(pair.effective_mass() / kStiffness);
  EXPECT_NEAR(collide(law, pair, 0.1, period / 10000).restitution, 0.541, 1e-3);
}

TEST(FullDamping, LetsHertzSpheresHardlySeparate) {
  const LawParameters law{.normal = HertzMindlinNormal::Parameters{.modulus = kModulus},
                          .damping = RestitutionDamping::Parameters{.restitution = 0, .modulus = kModulus}};
  const auto pair = spheres(2.5e-4, 2.5e-4);
  EXPECT_LT(collide(law, pair, 0.1, hertz_step(pair, 0.1), 100000).restitution, 0.02);
}

TEST(BierwischDampingPart, LosesMoreInFastCollisions) {
  // gamma_n sqrt(R h) v against Hertz is the viscoelastic sphere: 1 - e grows with v^(1/5) (Kuwabara, Kono).
  const auto pair = spheres(7.84e-5, 7.84e-5, 5400);
  const LawParameters law{.normal = BierwischNormal::Parameters{.reduced_modulus = 2 * kModulus},
                          .damping = BierwischDamping::Parameters{.damping = 0.2}};
  const auto lost = [&](double speed) {
    return 1 - collide(law, pair, speed, hertz_step(pair, speed)).restitution;
  };
  for (const double speed : {0.01, 0.1}) {
    EXPECT_GT(lost(speed), 1e-3);
    EXPECT_NEAR(std::log10(lost(10 * speed) / lost(speed)), 0.2, 2e-3) << speed;
  }
  const BierwischDamping part({.damping = 2}, pair);
  EXPECT_DOUBLE_EQ(part.force(4e-8, 2e-4, -0.5), 2 * std::sqrt(pair.effective_radius()) * 2e-4 * 0.5);
}

}  // namespace
}  // namespace diefill::engine::laws
