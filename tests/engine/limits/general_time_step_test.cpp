// The critical step of laws put together while the program runs, against closed forms and against the law
// that the engine knows in advance.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/coarse_graining/chu.h"
#include "engine/coarse_graining/sakai_koshizuka.h"
#include "engine/limits/pinching_contacts.h"
#include "engine/limits/stable_step.h"
#include "tests/support/contact_access.h"

namespace diefill::engine {
namespace {

using namespace laws;

constexpr double kRadius = 1e-3, kMass = 1e-5;  // m, kg

GeneralContact both(const LawParameters& law) {
  return {law, law, {}};
}

// Hertz' closed forms: h = (5 m_eff v^2 / (4 k))^(2/5) with k = 2/3 E~ sqrt(R_eff), k_n = E~ sqrt(R_eff h)
// and c = gamma_n sqrt(R_eff h).
TEST(GeneralTimeStep, IsTheClosedFormForHertz) {
  constexpr double kModulus = 1e7, kSpeed = 0.7;
  for (const auto& shape : {model_a(kRadius, kMass), model_d(kRadius, kMass)})
    for (const double damping : {0.0, 100.0, 3000.0}) {
      const auto law = bierwisch_law({.reduced_modulus = kModulus, .damping = damping});
      const double hertz = 2.0 / 3.0 * kModulus * std::sqrt(0.5 * kRadius);
      const double overlap = std::pow(1.25 * 0.5 * kMass * kSpeed * kSpeed / hertz, 0.4);
      EXPECT_NEAR(impact_overlap(shape, law, kSpeed), overlap, 1e-4 * overlap);
      const double mass = kMass / mobility(shape), root = std::sqrt(0.5 * kRadius * overlap);
      const double spring = 2 * std::sqrt(0.5 * mass / (kModulus * root));
      const double damper = damping > 0 ? mass / (damping * root) : 1;
      const double packed = 2 * std::sqrt(mass / (2 * kContactsPerGrain * kModulus * std::sqrt(0.1) * root));
      const double step = std::min({spring, damper, packed});
      EXPECT_NEAR(critical_time_step(shape, law, kSpeed), step, 1e-3 * step) << damping;
      // What a run checks its fastest grains by.
      const double collision = std::min(spring, damper);
      EXPECT_NEAR(collision_time_step(ParticleTypes({{shape}}), both(law), kSpeed), collision,
                  1e-3 * collision);
      const double deep = 0.5 * kRadius, wall = 3e-4, spacing = 5e-4;
      const double contacts = pinching_contacts(kRadius, wall, spacing, deep);
      const double at_wall = std::sqrt(effective_radius(kRadius, wall) * deep);
      const double pinched = stable_step(mass, contacts * kModulus * at_wall, contacts * damping * at_wall);
      EXPECT_NEAR(pinch_time_step(shape, both(law), wall, spacing, deep), pinched, 1e-9 * pinched);
    }
}

TEST(GeneralTimeStep, IsThatOfAnOscillatorForLinearSprings) {
  constexpr double kStiffness = 500, kSpeed = 0.5;  // N/m, m/s
  LawParameters law;
  law.normal = LinearNormal::Parameters{kStiffness};
  const GrainShape shape = model_a(kRadius, kMass);
  EXPECT_NEAR(impact_overlap(shape, both(law), kSpeed), kSpeed * std::sqrt(0.5 * kMass / kStiffness), 1e-9);
  const double oscillator = 2 * std::sqrt(0.5 * kMass / kStiffness);
  EXPECT_NEAR(critical_time_step(shape, both(law), kSpeed), oscillator / std::sqrt(kContactsPerGrain),
              1e-9 * oscillator);
  law.damping = ConstantDamping::Parameters{1.0};  // kg/s
  EXPECT_NEAR(critical_time_step(shape, both(law), kSpeed), 2 * 0.5 * kMass / 1.0, 1e-12);
}

double lasting_step(const GrainShape& shape, const GeneralContact& contact) {
  return lasting_contact_time_step(ParticleTypes({{shape}}), contact, {{}}, 0.5);
}

TEST(GeneralTimeStep, OfALastingContactIsThatOfSpringAndDamperTogether) {
  LawParameters law;
  law.normal = LinearNormal::Parameters{500};      // N/m
  law.damping = ConstantDamping::Parameters{1.0};  // kg/s
  GeneralContact contact = both(law);
  const double pair = stable_step(0.5 * kMass, 500, 1.0);
  EXPECT_NEAR(lasting_step(model_a(kRadius, kMass), contact), pair, 1e-9 * pair);

  contact.walls.damping = ConstantDamping::Parameters{3.0};
  const double wall = stable_step(kMass, 500, 3.0);
  EXPECT_NEAR(lasting_step(model_a(kRadius, kMass), contact), wall, 1e-9 * wall);

  // Sliding turns single spheres, which makes them 3.5 times as light.
  contact.grains.friction = LudingFriction::Parameters{
      .stiffness = 60, .damping = 5, .static_friction = 0.5, .dynamic_friction = 0.5};
  const double sliding = stable_step(0.5 * kMass / 3.5, 60, 5);
  EXPECT_NEAR(lasting_step(model_b(kRadius, kMass), contact), sliding, 1e-4 * sliding);
}

TEST(GeneralTimeStep, OfALastingContactIsTakenAtATenthOfTheOverlapOfTheImpact) {
  constexpr double kModulus = 1e7, kDamping = 3000;
  const auto law = bierwisch_law({.reduced_modulus = kModulus, .damping = kDamping});
  const GrainShape shape = model_a(kRadius, kMass);
  const double root = std::sqrt(0.5 * kRadius * 0.1 * impact_overlap(shape, law, 0.5));
  const double pair = stable_step(0.5 * kMass, kModulus * root, kDamping * root);
  EXPECT_NEAR(lasting_step(shape, both(law)), pair, 1e-3 * pair);
}

TEST(GeneralTimeStep, OfALastingContactIsNeverBelowFourTenthsOfTheCriticalOne) {
  LawParameters law;
  law.normal = LinearNormal::Parameters{500};
  double smallest = 1e300;
  for (double damping = 1e-3; damping < 1e2; damping *= 1.5) {
    law.damping = ConstantDamping::Parameters{damping};
    const GrainShape shape = model_a(kRadius, kMass);
    smallest = std::min(smallest, lasting_step(shape, both(law)) / critical_time_step(shape, both(law), 0.5));
  }
  EXPECT_GE(smallest, std::sqrt(2) - 1);
  EXPECT_LT(smallest, 0.55);
}

TEST(GeneralTimeStep, FollowsTheStiffestSpringWhicheverItIs) {
  const GrainShape shape = model_b(kRadius, kMass);
  constexpr double kModulus = 5e6, kOverlap = 1e-5;  // Pa, m
  LawParameters law;
  law.normal = HertzMindlinNormal::Parameters{kModulus};
  const double root = std::sqrt(0.5 * kRadius * kOverlap);
  const double normal = 2 * std::sqrt(0.5 * kMass / (2 * kModulus * root));
  EXPECT_NEAR(critical_time_step_at_overlap(shape, both(law), kOverlap), normal, 1e-9 * normal);

  law.friction = MindlinFriction::Parameters{.shear_modulus = 20 * kModulus, .friction = 0.5};
  const double tangential = 2 * std::sqrt(0.5 * kMass / 3.5 / (8 * 20 * kModulus * root));
  EXPECT_NEAR(critical_time_step_at_overlap(shape, both(law), kOverlap), tangential, 1e-4 * tangential);

  law.friction = {};
  law.rolling = Epsd2Rolling::Parameters{.rolling_friction = 0.5, .shear_modulus = 20 * kModulus};
  const double per_radian = 8 * 20 * kModulus * root * 0.25 * kRadius * kRadius;
  const double rolling = 2 * std::sqrt(0.5 * 0.4 * kMass * kRadius * kRadius / per_radian);
  EXPECT_NEAR(critical_time_step_at_overlap(shape, both(law), kOverlap), rolling, 1e-4 * rolling);
}

// A constant torque is as stiff as the step allows: it asks for none of its own.
TEST(GeneralTimeStep, ConstantTorqueAsksForNoStep) {
  const GrainShape shape = model_b(kRadius, kMass);
  LawParameters law;
  law.normal = LinearNormal::Parameters{500};
  const double plain = critical_time_step(shape, both(law), 0.5);
  law.rolling = LoadRolling::Parameters{.rolling_friction = 1};
  EXPECT_EQ(critical_time_step(shape, both(law), 0.5), plain);
  law.rolling = ElasticRolling::Parameters{.rolling_friction = 1, .stiffness = 500};
  EXPECT_EQ(critical_time_step(shape, both(law), 0.5), plain);
}

TEST(GeneralTimeStep, LudingsUnloadingSpringAndStifferWallsCount) {
  const GrainShape shape = model_a(kRadius, kMass);
  LawParameters law;
  law.normal = LudingNormal::Parameters{.loading = 100, .unloading = 2000};
  const double packed = 2 * std::sqrt(0.5 * kMass / 2000) / std::sqrt(kContactsPerGrain);
  EXPECT_NEAR(critical_time_step(shape, both(law), 0.5), packed, 1e-9 * packed);
  GeneralContact contact = both(law);
  contact.walls.normal = LinearNormal::Parameters{30 * 2000.0};
  const double wall = 2 * std::sqrt(kMass / (30 * 2000.0)) / std::sqrt(kContactsPerGrain);
  EXPECT_NEAR(critical_time_step(shape, contact, 0.5), wall, 1e-9 * wall);
}

// Hu 2024, section 4.3: springs that scale away from geometric similarity shorten the step by the root.
TEST(GeneralTimeStep, ShrinksWithTheSpringsOfForceScaling) {
  const GrainShape shape = model_a(kRadius, kMass);
  LawParameters law;
  law.normal = HertzMindlinNormal::Parameters{5e6};
  const double plain = critical_time_step_at_overlap(shape, both(law), 1e-5);
  for (const auto& scaling : {coarse_graining::chu(4), coarse_graining::sakai_koshizuka(4)}) {
    const double scaled = critical_time_step_at_overlap(shape, {law, law, scaling}, 1e-5);
    EXPECT_NEAR(scaled, plain / std::sqrt(scaling.spring_factor()), 1e-9 * scaled);
  }
}

// STABILITY.md: at 1.5 times the speed that escapes, about what passing the smallest gap takes. The well is
// twice as deep where grains touch as at the smallest gap, as the force is held from there on.
TEST(GeneralTimeStep, DoesNotJumpOverVanDerWaalsGap) {
  const GrainShape shape = model_a(kRadius, kMass);
  constexpr double kHamaker = 5e-16, kGap = 1e-9;  // J, m
  LawParameters law;
  law.normal = HertzMindlinNormal::Parameters{5e6};
  law.attraction =
      VanDerWaals::Parameters{.hamaker = kHamaker, .smallest_gap = kGap, .largest_gap = 1e3 * kGap};
  const double well = 2 * kHamaker * kRadius / 6 / kGap, speed = 1.5 * std::sqrt(2 * well / (0.5 * kMass));
  GeneralContact contact = both(law);
  contact.walls.attraction = {};
  EXPECT_NEAR(critical_time_step(shape, contact, 0.5), 2 * kGap / speed, 0.01 * kGap / speed);
}

TEST(GeneralTimeStep, AdhesionPullsGrainsDeeper) {
  const GrainShape shape = model_a(kRadius, kMass);
  LawParameters law;
  law.normal = JkrNormal::Parameters{.modulus = 5e6, .surface_energy = 0};
  const double plain = impact_overlap(shape, both(law), 0.1);
  law.normal = JkrNormal::Parameters{.modulus = 5e6, .surface_energy = 0.1};
  const double sticky = impact_overlap(shape, both(law), 0.1);
  EXPECT_GT(sticky, 1.01 * plain);
  // There, work done and energy brought along balance.
  const JkrNormal spring({.modulus = 5e6, .surface_energy = 0.1}, {kRadius, kRadius, kMass, kMass});
  const double brought = 0.5 * 0.5 * kMass * 0.1 * 0.1;
  EXPECT_NEAR(spring.energy(sticky, nullptr), brought, 1e-3 * brought);
}

}  // namespace
}  // namespace diefill::engine
