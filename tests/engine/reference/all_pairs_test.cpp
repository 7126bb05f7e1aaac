// The slow reference itself: conservation and energy accounts for every law, walls, periodic borders.
#include "all_pairs.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "engine/coarse_graining/methods.h"
#include "engine/coarse_graining/scaled_law.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine::reference {
namespace {

using laws::GeneralLaw;
using laws::PairProperties;
using Scaled = coarse_graining::ScaledLaw<GeneralLaw>;

constexpr double kRadius = 2.5e-4;

Ball ball(double radius, Vector3 position, Vector3 velocity = {}, Vector3 spin = {}) {
  Ball made;
  made.radius = radius;
  made.mass = 1000 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  made.position = position;
  made.velocity = velocity;
  made.spin = spin;
  return made;
}

/// Eight spinning balls of different size that fly at each other.
std::vector<Ball> cluster(double speed) {
  std::mt19937_64 random(3);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  std::vector<Ball> balls;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const Vector3 place{x + 0.05 * uniform(), y + 0.05 * uniform(), z + 0.05 * uniform()};
        const Vector3 spin{uniform(), uniform(), uniform()};
        balls.push_back(ball(kRadius * (1 + 0.2 * uniform()), (1.35 * kRadius) * place, -speed * place,
                             (0.5 * speed / kRadius) * spin));
      }
  return balls;
}

using Case = laws::ScaledCase;

class EveryLaw : public ::testing::TestWithParam<Case> {};

TEST_P(EveryLaw, ConservesMomentaAndBooksItsEnergy) {
  const auto& given = GetParam();
  laws::require_sensible(given.law.law);
  const auto rule = coarse_graining::force_scaling(given.method, given.scale);
  Settings settings;
  settings.time_step = 5e-8;
  settings.torque_factor = rule.torque_factor();
  AllPairs<Scaled> pairs(settings, [&](const PairProperties& pair) {
    return Scaled(rule, laws::make_law(given.law.law, rule.original(pair)));
  });
  pairs.balls = cluster(0.3);
  const Vector3 momentum = pairs.momentum(), angular = pairs.angular_momentum();
  const Energy start = pairs.energy();
  double momentum_scale = 0, touched = 0;
  for (const auto& one : pairs.balls) momentum_scale += one.mass * length(one.velocity);
  for (int step = 0; step < 12000; ++step) {
    pairs.step();
    touched += pairs.contacts();
  }
  EXPECT_GT(touched, 1000);
  EXPECT_LT(length(pairs.momentum() - momentum), 1e-12 * momentum_scale);
  EXPECT_LT(length(pairs.angular_momentum() - angular), 1e-12 * momentum_scale * kRadius * 4);

  const Energy end = pairs.energy();
  const double kinetic = start.translation + start.rotation;
  const double work =
      end.normal_work + end.viscous_work + end.friction_work + end.rolling_work + end.attraction_work;
  EXPECT_NEAR(end.translation + end.rotation, kinetic + work, 0.01 * kinetic);
  EXPECT_LE(end.viscous_work, 0);
  EXPECT_LT(end.friction_work, 0);
  EXPECT_LT(end.rolling_work, 0);
  EXPECT_LE(end.normal_work + end.contact, 0.01 * kinetic);  // a spring gives back no more than it holds
}

std::string name_of(const ::testing::TestParamInfo<Case>& instance) {
  std::string name = instance.param.law.name + instance.param.method;
  std::erase_if(name, [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Sources, EveryLaw,
                         ::testing::ValuesIn(laws::laws_under({"scaled-up particle", "Hu chapter 4 method 2",
                                                               "Sakai-Koshizuka"})),
                         name_of);

TEST(AllPairsReference, ElasticSpringsGiveAllBack) {
  const laws::LawParameters hertz{.normal = laws::HertzMindlinNormal::Parameters{.modulus = 5e6}};
  Settings settings;
  settings.time_step = 2e-8;
  AllPairs<GeneralLaw> pairs(settings, [&](const PairProperties& pair) { return make_law(hertz, pair); });
  pairs.balls = cluster(0.3);
  const Energy start = pairs.energy();
  double most_held = 0;
  for (int step = 0; step < 20000; ++step) {
    pairs.step();
    if (step % 100 != 0) continue;
    const Energy now = pairs.energy();
    EXPECT_NEAR(now.translation + now.contact, start.translation, 1e-3 * start.translation);
    EXPECT_NEAR(now.rotation, start.rotation, 1e-12 * start.rotation);
    most_held = std::max(most_held, now.contact);
  }
  EXPECT_GT(most_held, 0.05 * start.translation);
}

TEST(AllPairsReference, BallComesToRestOnAFloorWithItsWeight) {
  laws::LawParameters law{.normal = laws::HertzMindlinNormal::Parameters{.modulus = 5e6}};
  law.damping = laws::RestitutionDamping::Parameters{.restitution = 0.1, .modulus = 5e6};
  Settings settings;
  settings.time_step = 2e-7;
  settings.gravity = {0, 0, -9.81};
  AllPairs<GeneralLaw> pairs(settings, {}, [&](const PairProperties& pair) { return make_law(law, pair); });
  pairs.balls = {ball(kRadius, {0, 0, kRadius})};
  pairs.planes = {{}};
  pairs.planes[0].normal = {0, 0, 1};
  for (int step = 0; step < 100000; ++step) pairs.step();
  const double weight = pairs.balls[0].mass * 9.81;
  const double sunk = std::pow(weight / (4.0 / 3.0 * 5e6 * std::sqrt(kRadius)), 2.0 / 3.0);
  EXPECT_NEAR(kRadius - pairs.balls[0].position.z, sunk, 1e-3 * sunk);
  EXPECT_LT(length(pairs.balls[0].force), 1e-3 * weight);
}

TEST(AllPairsReference, MovingFloorCarriesABallAlong) {
  laws::LawParameters law{.normal = laws::LinearNormal::Parameters{.stiffness = 20}};
  law.damping = laws::ConstantDamping::Parameters{.coefficient = 1e-3};
  law.friction = laws::LudingFriction::Parameters{
      .stiffness = 20, .damping = 5e-4, .static_friction = 0.5, .dynamic_friction = 0.5};
  Settings settings;
  settings.time_step = 1e-6;
  settings.gravity = {0, 0, -9.81};
  AllPairs<GeneralLaw> pairs(settings, {}, [&](const PairProperties& pair) { return make_law(law, pair); });
  pairs.balls = {ball(kRadius, {0, 0, kRadius})};
  pairs.planes = {{}};
  pairs.planes[0].normal = {0, 0, 1};
  pairs.planes[0].velocity = {0.07, 0, 0};
  for (int step = 0; step < 100000; ++step) pairs.step();
  // A solid sphere laid on a belt ends rolling with 2/7 of the belt's speed.
  EXPECT_NEAR(pairs.balls[0].velocity.x, 0.02, 2e-4);
}

TEST(AllPairsReference, BordersThatRepeatChangeNothing) {
  const auto law = laws::laws_of_the_sources()[1].law;
  const double period = 10 * kRadius;
  const auto run = [&](double shift) {
    Settings settings;
    settings.time_step = 1e-7;
    settings.period = {period, {}};
    AllPairs<GeneralLaw> pairs(settings, [&](const PairProperties& pair) { return make_law(law, pair); });
    pairs.balls = {ball(kRadius, {shift - 1.1 * kRadius, 0, 0}, {0.2, 0, 0}),
                   ball(1.2 * kRadius, {std::fmod(shift + 1.1 * kRadius, period), 0, 1e-5}, {}, {10, 20, 0})};
    for (int step = 0; step < 3000; ++step) pairs.step();
    return pairs.balls;
  };
  const auto middle = run(0.5 * period), border = run(period);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(length(middle[k].velocity - border[k].velocity), 1e-9);
    EXPECT_LT(length(middle[k].spin - border[k].spin), 1e-6);
  }
  EXPECT_LT(middle[0].velocity.x, 0.15);
}

}  // namespace
}  // namespace diefill::engine::reference
