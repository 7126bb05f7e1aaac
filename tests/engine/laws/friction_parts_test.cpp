// Friction at a contact of constant load: sticking, slipping, reversing, and what the options change.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

constexpr double kLoad = 1e-4, kOverlap = 1e-6, kRoot = 1e-3, kStep = 1e-7;
const Vector3 kUp{0, 0, 1};
const PairProperties kPair = spheres(2.5e-4, 2.5e-4);

/// Drags a contact for a number of steps and returns the last force.
template <class Part>
Vector3 drag(const Part& part, double* history, Vector3 sliding, int steps, double load = kLoad) {
  Vector3 force;
  for (int k = 0; k < steps; ++k) force = part.force(history, kUp, sliding, kRoot, load, kStep);
  return force;
}

template <class Part>
class FrictionKinds : public ::testing::Test {};

struct CundallCase {
  static CundallFriction part() { return {{.tangential = 780, .friction = 0.5}, kPair}; }
};
struct MindlinCase {
  static MindlinFriction part() { return {{.shear_modulus = 1.13e6, .friction = 0.5}, kPair}; }
};
struct MindlinSpringAloneCase {
  static MindlinFriction part() {
    return {
        {.shear_modulus = 1.13e6, .friction = 0.5, .restitution = 0.5, .slip_test = SlipTest::spring_alone},
        kPair};
  }
};
struct LudingCase {
  static LudingFriction part() {
    return {{.stiffness = 90, .static_friction = 0.5, .dynamic_friction = 0.5}, kPair};
  }
};

using Kinds = ::testing::Types<CundallCase, MindlinCase, MindlinSpringAloneCase, LudingCase>;
TYPED_TEST_SUITE(FrictionKinds, Kinds);

TYPED_TEST(FrictionKinds, SlidesAtCoulombsLimitAgainstTheMotion) {
  const auto part = TypeParam::part();
  double history[4] = {};
  const Vector3 force = drag(part, history, {0.3, 0.4, 0}, 2000);
  EXPECT_NEAR(force.x, -0.5 * kLoad * 0.6, 1e-12 * kLoad);
  EXPECT_NEAR(force.y, -0.5 * kLoad * 0.8, 1e-12 * kLoad);
  EXPECT_EQ(force.z, 0);
}

TYPED_TEST(FrictionKinds, TurnsRoundAtOnceWhenTheMotionDoes) {
  const auto part = TypeParam::part();
  double history[4] = {};
  drag(part, history, {0.5, 0, 0}, 2000);
  const double before = drag(part, history, {0, 0, 0}, 1).x;
  EXPECT_GT(drag(part, history, {-0.01, 0, 0}, 1).x, before);
  EXPECT_NEAR(drag(part, history, {-0.5, 0, 0}, 4000).x, 0.5 * kLoad, 1e-12 * kLoad);
}

TYPED_TEST(FrictionKinds, SticksBelowTheLimit) {
  const auto part = TypeParam::part();
  double history[4] = {};
  drag(part, history, {1e-3, 0, 0}, 100);
  const Vector3 held = part.force(history, kUp, {}, kRoot, kLoad, kStep);
  EXPECT_NEAR(history[0], 1e-8, 1e-20);
  EXPECT_LT(length(held), 0.5 * kLoad);
  EXPECT_LT(held.x, 0);
  for (int k = 0; k < 100; ++k) EXPECT_DOUBLE_EQ(part.force(history, kUp, {}, kRoot, kLoad, kStep).x, held.x);
}

TYPED_TEST(FrictionKinds, GivesNothingWithoutLoad) {
  const auto part = TypeParam::part();
  double history[4] = {};
  EXPECT_EQ(length(part.force(history, kUp, {0.1, 0, 0}, 0, 0, kStep)), 0);
  EXPECT_LT(length(drag(part, history, {0.1, 0, 0}, 5, 0)), 1e-20);
  for (const double value : history) EXPECT_TRUE(std::isfinite(value));
}

TYPED_TEST(FrictionKinds, SpringStaysInTheTurningPlane) {
  const auto part = TypeParam::part();
  double history[4] = {1e-8, 0, 0, 0};
  for (int k = 0; k < 100; ++k) {
    const double angle = 0.01 * k;
    part.force(history, {std::sin(angle), 0, std::cos(angle)}, {}, kRoot, kLoad, kStep);
    EXPECT_NEAR(history[0] * std::sin(angle) + history[2] * std::cos(angle), 0, 1e-20);
  }
}

TEST(MindlinFrictionPart, HasHusStiffnessAndDashpot) {
  const double shear = 1.13122e6, restitution = 0.1;
  const MindlinFriction part({.shear_modulus = shear, .friction = 1e6, .restitution = restitution}, kPair);
  double history[3] = {};
  const double radius = kPair.effective_radius();
  const double stiffness = 8 * shear * std::sqrt(radius * kOverlap);
  const double beta = -restitution_damping_ratio(restitution);
  const double dashpot = -4 * std::sqrt(5.0 / 3.0) * beta * std::sqrt(kPair.effective_mass() * shear) *
                         std::pow(radius * kOverlap, 0.25);
  // LIGGGHTS writes the same as -2 sqrt(5/6) beta sqrt(S_t m*).
  EXPECT_NEAR(dashpot, -2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(stiffness * kPair.effective_mass()),
              1e-12 * dashpot);
  const Vector3 force = part.force(history, kUp, {0.1, 0, 0}, kRoot, kLoad, kStep);
  EXPECT_NEAR(force.x, -stiffness * 0.1 * kStep - dashpot * 0.1, 1e-12 * std::abs(force.x));
}

TEST(MindlinFrictionPart, RulesDifferOnlyByTheDashpot) {
  const auto make = [](SlipTest rule) {
    return MindlinFriction({.shear_modulus = 1.13e6, .friction = 0.5, .restitution = 0.1, .slip_test = rule},
                           kPair);
  };
  double both[3] = {}, alone[3] = {};
  // A kick whose dashpot alone exceeds the limit: cut by one rule, passed by the other while the spring
  // holds.
  const Vector3 fast{20, 0, 0};
  EXPECT_NEAR(make(SlipTest::spring_and_dashpot).force(both, kUp, fast, kRoot, kLoad, 1e-12).x, -0.5 * kLoad,
              1e-12 * kLoad);
  EXPECT_LT(make(SlipTest::spring_alone).force(alone, kUp, fast, kRoot, kLoad, 1e-12).x, -0.5 * kLoad);
  // After slipping, spring and dashpot together still make up the limit.
  const auto part = make(SlipTest::spring_and_dashpot);
  const double stiffness = part.spring_coefficient * kRoot,
               dashpot = part.dashpot_coefficient * std::sqrt(kRoot);
  EXPECT_NEAR(-stiffness * both[0] - dashpot * 20, -0.5 * kLoad, 1e-10 * kLoad);
}

TEST(LudingFrictionPart, SawsWithoutSlipMemoryAndNotWithIt) {
  const auto make = [](bool history) {
    return LudingFriction(
        {.stiffness = 90, .static_friction = 0.6, .dynamic_friction = 0.4, .slip_memory = history}, kPair);
  };
  for (const bool remembers : {false, true}) {
    const auto part = make(remembers);
    double history[4] = {};
    double low = kInfinite, high = 0;
    for (int k = 0; k < 4000; ++k) {
      const double force = length(part.force(history, kUp, {0.1, 0, 0}, kRoot, kLoad, kStep));
      if (k < 1000) continue;
      low = std::min(low, force);
      high = std::max(high, force);
    }
    EXPECT_NEAR(low, 0.4 * kLoad, 1e-10 * kLoad);
    if (remembers)
      EXPECT_NEAR(high, 0.4 * kLoad, 1e-10 * kLoad);
    else
      EXPECT_NEAR(high, 0.6 * kLoad, 90 * 0.1 * kStep);
  }
}

TEST(LudingFrictionPart, SlipMemoryEndsWhenTheMotionReverses) {
  const LudingFriction part(
      {.stiffness = 90, .static_friction = 0.6, .dynamic_friction = 0.4, .slip_memory = true}, kPair);
  double history[4] = {};
  drag(part, history, {0.1, 0, 0}, 1000);
  EXPECT_EQ(history[3], 1);
  drag(part, history, {-0.001, 0, 0}, 1);
  EXPECT_EQ(history[3], 0);
}

TEST(LudingFrictionPart, DashpotActsWhileStickingOnly) {
  const LudingFriction part(
      {.stiffness = 90, .damping = 1e-4, .static_friction = 0.5, .dynamic_friction = 0.5}, kPair);
  double history[4] = {};
  const double force = drag(part, history, {0.1, 0, 0}, 1).x;
  EXPECT_NEAR(force, -90 * 0.1 * kStep - 1e-5, 1e-18);
  EXPECT_NEAR(drag(part, history, {0.1, 0, 0}, 2000).x, -0.5 * kLoad, 1e-12 * kLoad);
}

}  // namespace
}  // namespace diefill::engine::laws
