// Central collisions of two grains against the closed forms of Hertz' law and the coefficients of restitution
// that follow from Bierwisch 2009, Eqs. 2.3 to 2.6.
#include <gtest/gtest.h>

#include "engine/laws/contact_law.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kFine = 1e-8;  // s

double hertz_coefficient(const GrainShape& shape) {
  return 2.0 / 3.0 * 1e7 * std::sqrt(0.5 * shape.sphere_radius);
}

TEST(Collision, HertzContactLastsAsLongAsClosedForm) {
  const auto settings = weightless(Model::a, {.damping_over_radius = 0}, 1e-7);
  const double speed = 0.2, reduced_mass = 0.5 * settings.shape().mass;
  const double k = hertz_coefficient(settings.shape());
  const double expected = 3.218 * std::pow(reduced_mass * reduced_mass / (k * k * speed), 0.2);
  const HeadOn collision = collide_head_on(settings, speed);
  EXPECT_NEAR(collision.duration, expected, 1e-3 * expected);
  EXPECT_NEAR(collision.duration, 5.96e-5, 1e-3 * 5.96e-5);
}

TEST(Collision, UndampedReboundIsAsFastAsImpact) {
  for (const Model model : {Model::a, Model::d})
    for (const double speed : {0.05, 0.2, 1.0}) {
      const auto settings = weightless(model, {.damping_over_radius = 0}, kFine);
      EXPECT_NEAR(collide_head_on(settings, speed).rebound, speed, 1e-6 * speed);
    }
}

TEST(Collision, DeepestOverlapIsWhereKineticEnergyIsStored) {
  const auto settings = weightless(Model::d, {.damping_over_radius = 0}, kFine);
  const double k = hertz_coefficient(settings.shape());
  for (const double speed : {0.01, 0.2, 1.0}) {
    const double expected = std::pow(1.25 * 0.5 * settings.shape().mass * speed * speed / k, 0.4);
    EXPECT_NEAR(collide_head_on(settings, speed).deepest, expected, 1e-6 * expected);
  }
}

struct RestitutionCase {
  const char* name;
  Model model;
  double damping_over_radius, work_of_adhesion, speed, expected;
};

class Restitution : public ::testing::TestWithParam<RestitutionCase> {};

TEST_P(Restitution, MatchesIntegratedEquationOfMotion) {
  const auto& given = GetParam();
  const auto settings = weightless(given.model,
                                   {.damping_over_radius = given.damping_over_radius,
                                    .friction = 1,
                                    .work_of_adhesion = given.work_of_adhesion},
                                   1e-7);
  const double restitution = collide_head_on(settings, given.speed).rebound / given.speed;
  RecordProperty("restitution", std::to_string(restitution));
  EXPECT_NEAR(restitution, given.expected, 0.01);
}

// From an integration of Eqs. 2.3 to 2.6 by other means (relative error below 1 %).
INSTANTIATE_TEST_SUITE_P(Bierwisch, Restitution,
                         ::testing::Values(RestitutionCase{"ALightlyDamped", Model::a, 1e5, 0, 0.2, 0.871},
                                           RestitutionCase{"ADamped", Model::a, 1e6, 0, 0.2, 0.259},
                                           RestitutionCase{"A1", Model::a, 1e6, 1e-2, 0.2, 0.148},
                                           RestitutionCase{"A1Fast", Model::a, 1e6, 1e-2, 0.5, 0.134},
                                           RestitutionCase{"DLightlyDamped", Model::d, 1e5, 0, 0.2, 0.938},
                                           RestitutionCase{"DDamped", Model::d, 1e6, 0, 0.2, 0.539},
                                           RestitutionCase{"D2LightlyDamped", Model::d, 1e5, 1e-2, 0.2,
                                                           0.929},
                                           RestitutionCase{"D2", Model::d, 1e6, 1e-2, 0.2, 0.482},
                                           RestitutionCase{"D1", Model::d, 1e6, 1.5e-1, 0.2, 0.149},
                                           RestitutionCase{"D1Fast", Model::d, 1e6, 1.5e-1, 0.5, 0.306}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Collision, SlowCohesiveGrainsStick) {
  const auto settings = weightless(Model::d, {.work_of_adhesion = 1.5e-1}, 1e-6);
  EXPECT_EQ(collide_head_on(settings, 0.05).rebound, 0);
}

TEST(Collision, DampingPushesApproachingAndPullsPartingSpheres) {
  const laws::HertzianDamping damping(78, 3.92e-5);
  const double root = std::sqrt(1e-7);
  EXPECT_GT(damping.force(root, -0.1), 0);
  EXPECT_LT(damping.force(root, 0.1), 0);
  EXPECT_NEAR(damping.force(root, -0.1), 78 * std::sqrt(3.92e-5 * 1e-7) * 0.1, 1e-18);
}

TEST(Collision, HertzEnergyAndStiffnessAreIntegralAndDerivativeOfForce) {
  const laws::Hertz hertz(1e7, 3.92e-5);
  const auto force = [&](double h) { return hertz.force(h, std::sqrt(h)); };
  const double h = 1e-6, step = 1e-10;
  EXPECT_NEAR((hertz.energy(h + step) - hertz.energy(h - step)) / (2 * step), force(h), 1e-7 * force(h));
  const double stiffness = hertz.stiffness(std::sqrt(h));
  EXPECT_NEAR((force(h + step) - force(h - step)) / (2 * step), stiffness, 1e-7 * stiffness);
  EXPECT_NEAR(stiffness, 1e7 * std::sqrt(3.92e-5 * h), 1e-12 * stiffness);
}

}  // namespace
}  // namespace diefill::engine
