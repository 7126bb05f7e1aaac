// Two spheres of unequal size and material: closed forms for what happens between them.
#include <gtest/gtest.h>

#include "engine/coarse_graining/scaled_up_particle.h"
#include "engine/contact/pair_laws.h"
#include "engine/limits/time_step.h"
#include "tests/engine/laws/source_laws.h"
#include "tests/engine/mixed_support.h"

namespace diefill::engine {
namespace {

constexpr double kModulus = 5e6;  // Pa, E*

laws::LawParameters hertz() {
  return {.normal = laws::HertzMindlinNormal::Parameters{.modulus = kModulus}};
}

GrainMix pair_of(double ratio, const laws::LawParameters& between) {
  // Laws of alike materials are different ones, so that a wrong look-up shows.
  const laws::LawParameters other = {.normal = laws::HertzMindlinNormal::Parameters{.modulus = 9 * kModulus}};
  return mix_of({1, ratio}, other, between, other);
}

struct PairCollision {
  double deepest = 0;               ///< m
  Eigen::Vector3d velocity, other;  ///< m/s, of both once they are apart
};

/// A still sphere of kind 0 at the origin is hit by one of kind 1 that comes along -x with `speed` (m/s).
PairCollision hit(const GrainMix& mix, double speed, double time_step) {
  Simulation simulation(settings_of(mix, time_step), {});
  std::vector<NewGrain> grains(2);
  grains[1].kind = 1;
  const double contact = mix.kinds[0].shape.sphere_radius + mix.kinds[1].shape.sphere_radius;
  grains[1].position.x() = contact;
  grains[1].velocity.x() = -speed;
  simulation.add_grains(grains);
  for (int k = 0; k < 1000000; ++k) {
    simulation.step();
    if ((position_of(simulation, 1) - position_of(simulation, 0)).norm() > contact) break;
  }
  return {simulation.deepest_overlap_of_run(), velocity_of(simulation, 0), velocity_of(simulation, 1)};
}

class UnequalSpheres : public ::testing::TestWithParam<double> {};

TEST_P(UnequalSpheres, OverlapAndReboundOfHertzFollowFromEffectiveRadiusAndMass) {
  const double ratio = GetParam(), speed = 0.4;
  const auto mix = pair_of(ratio, hertz());
  const double m0 = mix.kinds[0].shape.mass, m1 = mix.kinds[1].shape.mass;
  const double mass = m0 * m1 / (m0 + m1), radius = kMixRadius * ratio / (1 + ratio);
  // 1/2 m v^2 = 8/15 E* sqrt(R) h^(5/2).
  const double deepest = std::pow(15 * mass * speed * speed / (16 * kModulus * std::sqrt(radius)), 0.4);
  const double duration = 2.94 * deepest / speed;
  const auto after = hit(mix, speed, duration / 4000);
  EXPECT_NEAR(after.deepest, deepest, 1e-5 * deepest);
  EXPECT_NEAR(after.other.x(), -speed * (m1 - m0) / (m1 + m0), 1e-5 * speed);
  EXPECT_NEAR(after.velocity.x(), -speed * 2 * m1 / (m1 + m0), 1e-5 * speed);
}

TEST_P(UnequalSpheres, RestitutionOfALinearSpringIsTheOneAskedFor) {
  constexpr double kStiffness = 200, kRestitution = 0.6, kSpeed = 0.2;
  laws::LawParameters law;
  law.normal = laws::LinearNormal::Parameters{.stiffness = kStiffness};
  law.damping =
      laws::LinearRestitutionDamping::Parameters{.restitution = kRestitution, .stiffness = kStiffness};
  const auto mix = pair_of(GetParam(), law);
  const double m0 = mix.kinds[0].shape.mass, m1 = mix.kinds[1].shape.mass;
  const double half_period = std::numbers::pi * std::sqrt(m0 * m1 / (m0 + m1) / kStiffness);
  const auto after = hit(mix, kSpeed, half_period / 20000);
  EXPECT_NEAR((after.other - after.velocity).x(), kRestitution * kSpeed, 1e-3 * kSpeed);
  EXPECT_NEAR(m0 * after.velocity.x() + m1 * after.other.x(), -m1 * kSpeed, 1e-12 * m1 * kSpeed);
}

TEST_P(UnequalSpheres, PullOffForceIsThatOfTheWorkOfAdhesionOfBothMaterials) {
  // -3/2 pi w R_eff (Bierwisch 2009, Eq. 2.5).
  constexpr double kWork = 0.07;
  laws::LawParameters sticky, dry;
  sticky.normal = laws::BierwischNormal::Parameters{.reduced_modulus = 1e7, .work_of_adhesion = kWork};
  dry.normal = laws::BierwischNormal::Parameters{.reduced_modulus = 1e7, .work_of_adhesion = 0.3};
  const auto mix = mix_of({1, GetParam()}, dry, sticky, dry);
  const ParticleTypes kinds(mix.kinds);
  const double radius = kMixRadius * GetParam() / (1 + GetParam());
  for (const auto& [i, j] : {std::pair<ClassNumber, ClassNumber>{0, 1}, {1, 0}}) {
    const auto law = law_between(kinds, mix, i, j);
    double lowest = 0;
    for (double overlap = 1e-9; overlap < 0.1 * radius; overlap *= 1.0005) {
      double history[laws::GeneralContactLaw::kHistory + 1] = {};
      const laws::ContactState static_normal = {.overlap = overlap, .normal = {1, 0, 0}, .time_step = 1e-9};
      lowest = std::min(lowest, law.react(static_normal, history).force.x);
    }
    EXPECT_NEAR(lowest, -1.5 * std::numbers::pi * kWork * radius, 1e-5 * -lowest);
  }
}

TEST_P(UnequalSpheres, ContactsTurnBothByTheirOwnArms) {
  // A spinning sphere rubs a still one: the same tangential impulse turns each with its own radius over its
  // own moment of inertia, both the same way round.
  const double ratio = GetParam();
  auto law = hertz();
  law.friction = laws::CundallFriction::Parameters{.tangential = 100, .friction = 0.4};
  const auto mix = pair_of(ratio, law);
  Simulation simulation(settings_of(mix, 2e-8), {});
  std::vector<NewGrain> grains(2);
  grains[1].kind = 1;
  grains[1].position.x() = kMixRadius * (1 + ratio);
  grains[1].velocity.x() = -0.3;
  grains[1].angular_velocity.z() = 50;
  simulation.add_grains(grains);
  run_steps(simulation, 4000);
  const auto &one = mix.kinds[0].shape, &other = mix.kinds[1].shape;
  const double turned = simulation.angular_velocity(place_of(simulation, 0)).z();
  const double lost = simulation.angular_velocity(place_of(simulation, 1)).z() - 50;
  EXPECT_LT(turned, -1e-6);
  const double expected =
      turned * (other.sphere_radius / other.inertia.z()) / (one.sphere_radius / one.inertia.z());
  EXPECT_NEAR(lost, expected, 1e-9 * std::abs(expected));
}

INSTANTIATE_TEST_SUITE_P(Ratios, UnequalSpheres, ::testing::Values(0.1, 0.5, 1.0, 3.0));

TEST(MixTimeStep, IsSetByTheSmallestGrainsAndByTheStiffestLaw) {
  auto mix = mix_of({1, 0.2}, hertz(), hertz(), hertz());
  const double both = critical_time_step(mix, {}, 0.5);
  auto small = mix;
  small.kinds.erase(small.kinds.begin());
  const double smallest = critical_time_step(small, {}, 0.5);
  EXPECT_LE(both, smallest);
  EXPECT_GT(both, 0.5 * smallest);
  for (auto& law : mix.laws)
    if (law.first == "wax" && law.second == "wax")
      law.law.normal = laws::HertzMindlinNormal::Parameters{.modulus = 100 * kModulus};
  EXPECT_LT(critical_time_step(mix, {}, 0.5), 0.5 * both);
  EXPECT_LE(critical_time_step(mix, {{"steel", 1e-4}}, 0.5), critical_time_step(mix, {}, 0.5));
}

// Springs of friction and rolling and attraction count as they do among grains of one size.
TEST(MixTimeStep, IsNeverAboveThatOfTheSmallestGrainsAlone) {
  std::vector<laws::LawParameters> all(1, hertz());
  all.back().friction = laws::MindlinFriction::Parameters{.shear_modulus = kModulus, .friction = 0.5};
  all.push_back(hertz());
  all.back().rolling =
      laws::Epsd2Rolling::Parameters{.rolling_friction = 0.5, .shear_modulus = 20 * kModulus};
  for (const auto& named : laws::laws_of_the_sources()) all.push_back(named.law);
  for (const auto& law : all) {
    laws::LawParameters walls = law;
    walls.attraction = {};
    const auto mix = mix_of({0.2, 1, 3}, law, law, walls);
    const double infinite = std::numeric_limits<double>::infinity();
    const double both = critical_time_step(mix, {{"steel", infinite}}, 0.5);
    const double alone = critical_time_step(mix.kinds.front().shape, GeneralContact{law, walls, {}}, 0.5);
    EXPECT_LE(both, alone * (1 + 1e-6));
    EXPECT_GT(both, 0.4 * alone);
  }
}

TEST(MixTimeStep, GrowsWithTheScaleOfScaledUpParticles) {
  auto mix = mix_of({1, 0.5}, hertz(), hertz(), hertz());
  const double fine = critical_time_step(mix, {}, 0.5);
  for (auto& kind : mix.kinds) kind.shape = model_b(4 * kind.shape.sphere_radius, 64 * kind.shape.mass);
  mix.scaling = coarse_graining::scaled_up_particle(4);
  EXPECT_NEAR(critical_time_step(mix, {}, 0.5), 4 * fine, 1e-6 * fine);
}

TEST(MixTimeStep, AtOverlapsIsThatOfThePairThatReachesThem) {
  const auto mix = mix_of({1, 0.2}, hertz(), hertz(), hertz());
  auto small = mix;
  small.kinds.erase(small.kinds.begin());
  const double impact = critical_time_step(small, {}, 0.5);
  // Small ones held by large ones meet stiffer contacts than among themselves: R_eff 5/6 R in place of 1/2 R.
  EXPECT_NEAR(critical_time_step_at_overlap(mix, 1, 1e-2),
              critical_time_step_at_overlap(small, 1, 1e-2) * std::pow(0.6, 0.25), 1e-9 * impact);
  const double deep = 1e-2 * kMixRadius * 0.2;
  // Large ones overlap as deep in metres: small ones have not, and their limit does not count.
  EXPECT_GT(critical_time_step_at_overlap(mix, 5 * deep, 1e-3),
            critical_time_step_at_overlap(mix, 5 * deep, 1e-2));
  // Hertz: the step goes with the fourth root of the overlap.
  EXPECT_NEAR(critical_time_step_at_overlap(small, deep, 1),
              2 * critical_time_step_at_overlap(small, 16 * deep, 1), 1e-6 * impact);
}

}  // namespace
}  // namespace diefill::engine
