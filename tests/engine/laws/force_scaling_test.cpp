// Coarse graining by force scaling: the two ways of the scaled-up particle, factors of the other rules,
// spheres thrown on a floor.
#include "engine/coarse_graining/methods.h"
#include "engine/coarse_graining/scaled_law.h"
#include "engine/coarse_graining/similar_parameters.h"
#include "law_test_support.h"
#include "source_laws.h"

namespace diefill::engine::coarse_graining {
namespace {

using laws::ContactState;
using laws::GeneralLaw;
using laws::LawParameters;
using laws::laws_of_the_sources;
using laws::PairProperties;
using Scaled = ScaledLaw<GeneralLaw>;

Scaled scaled_law(const LawParameters& fine, const ForceScaling& scaling, const PairProperties& coarse_pair) {
  return {scaling, laws::make_law(fine, scaling.original(coarse_pair))};
}

ContactState state_at(int step, double length_scale) {
  ContactState state;
  const double t = 0.01 * step;
  state.overlap = length_scale * (1e-5 * std::sin(1.7 * t) + 1e-6 * std::sin(13 * t));
  state.normal = {std::sin(0.1 * t), 0, std::cos(0.1 * t)};
  state.velocity = {0.1 * std::sin(t), 0.05, 0.2 * std::cos(1.7 * t)};
  state.spin = (1 / length_scale) * Vector3{200 * std::cos(t), 30, -100};
  state.time_step = length_scale * 1e-6;
  state.rolling_step = state.time_step;
  return state;
}

void expect_close(Vector3 a, Vector3 b, const std::string& what) {
  EXPECT_LE(length(a - b), 1e-12 * length(b)) << what;
}

TEST(ScaledUpParticle, IsTheOrdinaryLawWithScaledParameters) {
  // (a) of Hu's identities: original variables against scaled parameters and torques times torque_factor()
  // (Hu 2024, Eqs. 3.46 to 3.48).
  for (const double scale : {2.0, 4.0, 7.3}) {
    const auto rule = scaled_up_particle(scale);
    auto coarse = laws::spheres(2.5e-4 * scale, 4e-4 * scale);
    for (const auto& [name, fine] : laws_of_the_sources()) {
      const auto direct = scaled_law(fine, rule, coarse);
      auto weak_torque = coarse;
      weak_torque.inertia_factor = 1 / rule.torque_factor();
      const auto by_parameters = laws::make_law(fine.similar(scale), weak_torque);
      std::vector<double> one(GeneralLaw::kHistory), other(GeneralLaw::kHistory);
      EXPECT_NEAR(direct.range(), by_parameters.range(), 1e-12 * by_parameters.range());
      for (int step = 0; step < 600; ++step) {
        const auto state = state_at(step, scale);
        const auto a = direct.react(state, one.data());
        const auto b = by_parameters.react(state, other.data());
        expect_close(a.force, b.force, name + " force");
        expect_close(a.torque, b.torque, name + " couple");
        EXPECT_NEAR(a.load, b.load, 1e-12 * b.load) << name;
        EXPECT_NEAR(a.friction_power, b.friction_power, 1e-10 * std::abs(b.friction_power)) << name;
        EXPECT_NEAR(a.rolling_power, b.rolling_power, 1e-10 * std::abs(b.rolling_power)) << name;
        const double energy = by_parameters.contact_energy(state.overlap, other.data());
        EXPECT_NEAR(direct.contact_energy(state.overlap, one.data()), energy, 1e-10 * std::abs(energy))
            << name;
        const double pull = by_parameters.attraction_energy(state.overlap, other.data());
        EXPECT_NEAR(direct.attraction_energy(state.overlap, one.data()), pull, 1e-10 * std::abs(pull))
            << name;
      }
    }
  }
}

TEST(ForceScalingRules, CoincideAtScaleOne) {
  // (c) of Hu's identities.
  const auto pair = laws::spheres(2.5e-4, 4e-4);
  for (const auto& method : kMethods) {
    const auto rule = force_scaling(method.name, 1);
    EXPECT_EQ(rule.torque_factor(), 1);
    for (const auto& [name, law] : laws_of_the_sources()) {
      const auto scaled = scaled_law(law, rule, pair);
      const auto plain = laws::make_law(law, pair);
      std::vector<double> one(GeneralLaw::kHistory), other(GeneralLaw::kHistory);
      for (int step = 0; step < 300; ++step) {
        const auto a = scaled.react(state_at(step, 1), one.data());
        const auto b = plain.react(state_at(step, 1), other.data());
        expect_close(a.force, b.force, name);
        expect_close(a.torque, b.torque, name);
      }
    }
  }
}

TEST(ForceScalingRules, HaveThePublishedFactors) {
  const auto factors = [](const char* name, double scale) {
    const auto rule = force_scaling(name, scale);
    return std::array{rule.torque_factor(), rule.spring_factor(), rule.damping_factor()};
  };
  const auto expect = [&](const char* name, double torque, double spring, double damping) {
    const auto found = factors(name, 4);
    EXPECT_NEAR(found[0], std::pow(4, torque), 1e-12) << name;
    EXPECT_NEAR(found[1], std::pow(4, spring), 1e-12) << name;
    EXPECT_NEAR(found[2], std::pow(4, damping), 1e-12) << name;
  };
  expect("none", 0, 0, 0);
  expect("scaled-up particle", -1, 0, 0);
  expect("Hu chapter 4 method 2", -1, 1.5, 0.25);
  expect("Hu chapter 4 method 3", -1, 1, 1);
  expect("Hu chapter 5 method 2", 0, 0, 0);
  expect("Hu chapter 5 method 3", -1, 1, 1);
  expect("Sakai-Koshizuka", 0, 2.5, 1.25);
  expect("Chu", 0, 1.5, 0.25);
  EXPECT_NEAR(factors("Hu chapter 4 method 2", 2)[1], 2.83, 0.002);
  EXPECT_THROW(force_scaling("Hu", 2), std::invalid_argument);
  EXPECT_THROW(force_scaling("Chu", 0), std::invalid_argument);
}

TEST(ForceScalingRules, StiffenSpringsByTheirFactors) {
  for (const auto& method : kMethods) {
    const double scale = 4;
    const auto rule = force_scaling(method.name, scale);
    const auto coarse = laws::spheres(1e-3, 1e-3);
    const auto hu = laws_of_the_sources()[1].law;
    auto state = state_at(30, 1);
    ASSERT_GT(state.overlap, 0);
    const auto normal_and_friction = [&](const auto& law) {
      std::vector<double> history(GeneralLaw::kHistory);
      const auto reaction = law.react(state, history.data());
      const double normal = dot(reaction.force, state.normal);
      const double tangential = length(reaction.force - normal * state.normal);
      return std::array{normal - reaction.viscous, reaction.viscous, tangential};
    };
    auto spring_only = hu;  // so little motion that friction sticks, without dashpot
    spring_only.friction = laws::MindlinFriction::Parameters{.shear_modulus = 1.13e6, .friction = 1e9};
    const auto found = normal_and_friction(scaled_law(spring_only, rule, coarse));
    const auto plain = normal_and_friction(laws::make_law(spring_only, coarse));
    EXPECT_NEAR(found[0] / plain[0], rule.spring_factor(), 1e-9 * rule.spring_factor()) << method.name;
    EXPECT_NEAR(found[1] / plain[1], rule.damping_factor(), 1e-9 * rule.damping_factor()) << method.name;
    EXPECT_NEAR(found[2] / plain[2], rule.spring_factor(), 1e-9 * rule.spring_factor()) << method.name;
  }
}

TEST(ForceScalingRules, LiteralSpringsAreStiffer) {
  const double scale = 4;
  auto rule = scaled_up_particle(scale);
  const auto coarse = laws::spheres(1e-3, 1e-3);
  LawParameters law;
  law.friction = laws::MindlinFriction::Parameters{.shear_modulus = 1.13e6, .friction = 1e9};
  law.rolling = laws::Epsd2Rolling::Parameters{.rolling_friction = 1e9, .shear_modulus = 1.13e6};
  const auto pull = [&] {
    std::vector<double> history(GeneralLaw::kHistory);
    auto state = state_at(30, 1);
    const auto reaction = scaled_law(law, rule, coarse).react(state, history.data());
    const double normal = dot(reaction.force, state.normal);
    return std::array{length(reaction.force - normal * state.normal), length(reaction.torque)};
  };
  const auto similar = pull();
  rule.literal_spring = true;
  const auto literal_spring = pull();
  EXPECT_NEAR(literal_spring[0] / similar[0], scale, 1e-10);
  EXPECT_NEAR(literal_spring[1] / similar[1], 1, 1e-10);
  rule.literal_rolling = true;
  EXPECT_NEAR(pull()[1] / similar[1], scale, 1e-10);
}

TEST(ForceScalingRules, UnscaledGapsCutLiquidBridgesShort) {
  // Hu 2024, chapter 4: forces of Method 2 at shares of the scaled rupture distance over those of SUP.
  LawParameters wet;
  wet.attraction = laws::CapillaryBridge::Parameters{.surface_tension = 0.1};
  const auto force = [&](const char* name, double scale, double share) {
    const auto coarse = laws::spheres(2.5e-4 * scale, 2.5e-4 * scale);
    const auto law = scaled_law(wet, force_scaling(name, scale), coarse);
    const double rupture = scaled_law(wet, scaled_up_particle(scale), coarse).range();
    std::vector<double> history(GeneralLaw::kHistory);
    ContactState state;
    state.normal = {0, 0, 1};
    law.react(state, history.data());  // touch
    state.overlap = -share * rupture;
    return law.react(state, history.data()).force.z;
  };
  const auto ratio = [&](double scale, double share) {
    return force("Hu chapter 4 method 2", scale, share) / force("scaled-up particle", scale, share);
  };
  EXPECT_NEAR(ratio(2, 0.245), 0.51, 0.005);
  EXPECT_EQ(ratio(2, 0.735), 0);
  EXPECT_NEAR(ratio(4, 0.245), 0.18, 0.005);
  EXPECT_EQ(ratio(4, 0.735), 0);
}

struct Throw {
  std::string method;
  double scale, speed_share;
};

class ThrownSphere : public ::testing::TestWithParam<Throw> {};

TEST_P(ThrownSphere, RollsFromThePredictedSpeed) {
  // (d) of Hu's identities: v / v_0 = 1 / (1 + 2 / (5 c_T)).
  const auto& given = GetParam();
  const double radius = 2.5e-4 * given.scale, start = 0.1, friction = 0.3, gravity = 9.81;
  const auto rule = force_scaling(given.method, given.scale);
  LawParameters law{.normal = laws::LinearNormal::Parameters{.stiffness = 20}};
  law.damping = laws::ConstantDamping::Parameters{.coefficient = 3e-5};
  law.friction = laws::LudingFriction::Parameters{
      .stiffness = 200, .damping = 1e-3, .static_friction = friction, .dynamic_friction = friction};
  const double time_step = 1e-6 * given.scale;
  reference::AllPairs<Scaled> pairs({.time_step = time_step,
                                     .gravity = {0, 0, -gravity},
                                     .arm = reference::Arm::surface,
                                     .torque_factor = rule.torque_factor()},
                                    {},
                                    [&](const PairProperties& pair) { return scaled_law(law, rule, pair); });
  reference::Ball ball{.radius = radius, .mass = laws::sphere_mass(radius, 1000)};
  ball.position = {0, 0, radius - ball.mass * gravity / (20 * given.scale)};  // at rest under its weight
  ball.velocity = {start, 0, 0};
  pairs.balls = {ball};
  pairs.planes = {{.normal = {0, 0, 1}}};
  const double rolls_at = start / (friction * gravity) / (1 + 2.5 * rule.torque_factor());
  const int steps = static_cast<int>(2 * rolls_at / time_step);
  for (int k = 0; k < steps; ++k) pairs.step();
  const double speed = pairs.balls[0].velocity.x;
  EXPECT_NEAR(speed / start, given.speed_share, 2e-4);
  EXPECT_NEAR(pairs.balls[0].spin.y * radius, speed, 1e-4 * speed);
}

INSTANTIATE_TEST_SUITE_P(Methods, ThrownSphere,
                         ::testing::Values(Throw{"none", 1, 0.7143}, Throw{"scaled-up particle", 1, 0.7143},
                                           Throw{"scaled-up particle", 2, 0.5556},
                                           Throw{"scaled-up particle", 4, 0.3846},
                                           Throw{"Hu chapter 5 method 2", 2, 0.7143},
                                           Throw{"Hu chapter 5 method 2", 4, 0.7143}));

/// Two spheres that collide off centre under a rule; returns them afterwards.
std::vector<reference::Ball> glancing(const ForceScaling& rule, const LawParameters& law,
                                      double inertia_share, double radius, int steps, double time_step) {
  const double factor = rule.torque_factor() / inertia_share;
  reference::AllPairs<Scaled> pairs(
      {.time_step = time_step, .arm = reference::Arm::surface, .torque_factor = factor},
      [&](const PairProperties& pair) { return scaled_law(law, rule, pair); });
  reference::Ball one{.radius = radius, .mass = laws::sphere_mass(radius, 1000)}, other = one;
  one.position = {0, 0, 2 * radius};
  one.velocity = {0.05, 0.02, -0.1};
  one.spin = (0.01 / radius) * Vector3{1, 2, 3};
  pairs.balls = {one, other};
  for (int k = 0; k < steps; ++k) pairs.step();
  return pairs.balls;
}

TEST(ScaledUpParticle, WithInertiaOverScaleIsMethodTwoOfChapterFive) {
  // (b) of Hu's identities.
  for (const double scale : {2.0, 4.0}) {
    const auto law = laws_of_the_sources()[1].law;
    const double radius = 2.5e-4 * scale;
    const auto a = glancing(scaled_up_particle(scale), law, 1 / scale, radius, 3000, 1e-7 * scale);
    const auto b = glancing(hu_chapter_5_method_2(scale), law, 1, radius, 3000, 1e-7 * scale);
    EXPECT_LT(length(a[0].velocity - b[0].velocity), 1e-12);
    EXPECT_LT(length(a[0].spin - b[0].spin), 1e-12 * length(b[0].spin));
    EXPECT_GT(length(a[0].velocity - Vector3{0.05, 0.02, -0.1}), 0.01);
  }
}

TEST(GeometricSimilarity, RunsTheSameTrajectoryInUnitsOfTheGrain) {
  // Method 2 of chapter 5 at scale l with steps l times as long is the original collision, as is Thakur's way
  // by parameters.
  for (const auto& [name, law] : laws_of_the_sources()) {
    const auto fine = glancing(unscaled(), law, 1, 2.5e-4, 3000, 1e-8);
    const auto coarse = glancing(hu_chapter_5_method_2(4), law, 1, 1e-3, 3000, 4e-8);
    const auto by_parameters = glancing(unscaled(), similar_parameters(law, 4), 1, 1e-3, 3000, 4e-8);
    for (const auto* way : {&coarse, &by_parameters}) {
      EXPECT_LT(length((*way)[0].velocity - fine[0].velocity), 1e-9) << name;
      EXPECT_LT(length(4.0 * (*way)[0].spin - fine[0].spin), 1e-9 * length(fine[0].spin)) << name;
      EXPECT_LT(length(0.25 * (*way)[0].position - fine[0].position), 1e-12) << name;
    }
  }
}

}  // namespace
}  // namespace diefill::engine::coarse_graining
