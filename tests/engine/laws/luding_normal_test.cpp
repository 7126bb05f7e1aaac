// Luding's hysteretic spring over load cycles, compared with an independent bookkeeping of its lines.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

// LH100 (Kottlan 2018, Table 11) with k_1 = 150 N/m.
constexpr double kK1 = 150, kK2 = 5.33 * kK1, kKc = 0.0667 * kK1, kRadius = 66.67e-6, kDepth = 0.0133;

const LudingNormal::Parameters kParameters{
    .loading = kK1, .unloading = kK2, .cohesion = kKc, .plasticity_depth = kDepth};
const double kLimit = kK2 / (kK2 - kK1) * kDepth * kRadius;  // m, equal spheres: 2 R_ij = r

class LudingCycle : public ::testing::Test {
 protected:
  LudingNormal part{kParameters, spheres(kRadius, kRadius, 1545)};
  double history = 0;

  StaticForce at(double overlap) { return part.force(overlap, std::sqrt(overlap), &history); }
  /// Moves in small steps to `overlap` and returns the force there; adds to the work done on the spheres.
  double go(double from, double to, int steps = 4000) {
    double before = from > 0 ? at(from).force : 0, now = before;
    for (int k = 1; k <= steps; ++k) {
      now = at(from + (to - from) * k / steps).force;
      work += 0.5 * (before + now) * (to - from) / steps;
      before = now;
    }
    return now;
  }
  double work = 0;
};

TEST_F(LudingCycle, LoadsAlongTheSoftLine) {
  for (const double share : {0.1, 0.5, 0.9}) {
    const auto force = at(share * kLimit);
    EXPECT_NEAR(force.force, kK1 * share * kLimit, 1e-12 * kK1 * kLimit);
    EXPECT_NEAR(force.limit, (kK1 + kKc) * share * kLimit, 1e-12 * kK1 * kLimit);
  }
}

TEST_F(LudingCycle, UnloadsThroughTheExpectedZeroAndLimb) {
  const double deepest = 0.5 * kLimit, slope = 0.5 * (kK1 + kK2), zero = deepest * (1 - kK1 / slope);
  go(0, deepest);
  EXPECT_DOUBLE_EQ(part.unloading_slope(deepest), slope);
  EXPECT_NEAR(at(zero).force, 0, 1e-10 * kK1 * deepest);
  EXPECT_NEAR(at(1.2 * zero).force, slope * 0.2 * zero, 1e-10 * kK1 * deepest);
  // Most attractive where the unloading line meets the cohesion branch.
  const double corner = slope / (slope + kKc) * zero;
  EXPECT_NEAR(at((1 + 1e-9) * corner).force, -kKc * corner, 1e-7 * kKc * corner);
  EXPECT_DOUBLE_EQ(history, deepest);
  EXPECT_NEAR(at((1 - 1e-9) * corner).force, -kKc * corner, 1e-7 * kKc * corner);
  EXPECT_NEAR(history, deepest, 1e-7 * deepest);
}

TEST_F(LudingCycle, LimbShortensTheMemoryAndLeavesNoFriction) {
  const double deepest = 0.5 * kLimit, slope = 0.5 * (kK1 + kK2);
  go(0, deepest);
  const double corner = slope / (slope + kKc) * deepest * (1 - kK1 / slope);
  const auto force = at(0.3 * corner);
  EXPECT_NEAR(force.force, -kKc * 0.3 * corner, 1e-12 * kK1 * deepest);
  EXPECT_NEAR(force.limit, 0, 1e-12 * kK1 * deepest);
  EXPECT_NEAR(history, (slope + kKc) / (slope - kK1) * 0.3 * corner, 1e-12 * deepest);
  EXPECT_LT(history, deepest);
}

TEST_F(LudingCycle, MinorLoopRunsBackOnItsOwnLine) {
  const double deepest = 0.6 * kLimit;
  go(0, deepest);
  const double slope = part.unloading_slope(deepest);
  const double down = go(deepest, 0.9 * deepest);
  EXPECT_NEAR(down, kK1 * deepest - slope * 0.1 * deepest, 1e-10 * kK1 * deepest);
  EXPECT_NEAR(go(0.9 * deepest, deepest), kK1 * deepest, 1e-10 * kK1 * deepest);
  EXPECT_DOUBLE_EQ(history, deepest);
  // Beyond the old turning point virgin loading goes on.
  EXPECT_NEAR(go(deepest, 1.1 * deepest), kK1 * 1.1 * deepest, 1e-10 * kK1 * deepest);
}

TEST_F(LudingCycle, BeyondThePlasticLimitOneSteepLineServes) {
  go(0, 1.5 * kLimit);
  const double zero = kDepth * kRadius;  // = delta_0 = phi_f 2 R_ij
  for (const double overlap : {1.01 * zero, 1.2 * kLimit, 1.5 * kLimit, 2 * kLimit})
    EXPECT_NEAR(at(overlap).force, kK2 * (overlap - zero), 1e-10 * kK2 * kLimit);
  const double corner = kK2 / (kK2 + kKc) * zero;
  EXPECT_NEAR(at((1 - 1e-9) * corner).force, -kKc * corner, 1e-7 * kKc * corner);
  EXPECT_NEAR(at(0.5 * zero).force, -kKc * 0.5 * zero,
              1e-12 * kK2 * kLimit);  // large overlaps have a cohesion branch, too
}

TEST_F(LudingCycle, EnergyIsWhatUnloadingGivesBack) {
  const double deepest = 0.7 * kLimit;
  go(0, deepest);
  const double stored = part.energy(deepest, &history);
  const double slope = part.unloading_slope(deepest);
  EXPECT_NEAR(stored, std::pow(kK1 * deepest, 2) / (2 * slope), 1e-12 * stored);
  EXPECT_NEAR(work, 0.5 * kK1 * deepest * deepest, 1e-6 * work);
  work = 0;
  go(deepest, deepest * (1 - kK1 / slope));
  EXPECT_NEAR(-work, stored, 1e-6 * stored);
}

TEST_F(LudingCycle, CyclesNeverYieldEnergy) {
  double here = 0;
  double least = 0;
  for (const double turn : {0.4, 0.1, 0.8, 0.3, 0.5, 0.02, 1.4, 0.2, 1.6, 0.0}) {
    go(here, turn * kLimit);
    here = turn * kLimit;
    const double lost = work - part.energy(here, &history);
    EXPECT_GE(lost, least - 1e-9 * kK1 * kLimit * kLimit) << turn;
    least = lost;
  }
}

struct Anchor {
  double speed, depth, undamped, damped, duration;
};

class LudingCollision : public ::testing::TestWithParam<Anchor> {};

TEST_P(LudingCollision, ReturnsThePublishedSpeed) {
  const auto pair = spheres(kRadius, kRadius, 1545);
  const double dt = std::numbers::pi * std::sqrt(pair.effective_mass() / kK1) / 2000;
  LawParameters law{.normal = kParameters};
  const auto free = collide(law, pair, GetParam().speed, dt);
  EXPECT_NEAR(free.restitution, GetParam().undamped, 0.002);
  EXPECT_NEAR(free.deepest / kLimit, GetParam().depth, 5e-4);
  EXPECT_NEAR(free.duration * 1e6, GetParam().duration, 0.02);
  law.damping = LinearRestitutionDamping::Parameters{.restitution = 0.65, .stiffness = kK1};
  EXPECT_NEAR(collide(law, pair, GetParam().speed, dt).restitution, GetParam().damped, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Speeds, LudingCollision,
                         ::testing::Values(Anchor{0.01, 0.0232, 0.953, 0.614, 8.00},
                                           Anchor{0.05, 0.1158, 0.812, 0.501, 8.25},
                                           Anchor{0.10, 0.2316, 0.695, 0.404, 8.59},
                                           Anchor{0.20, 0.4633, 0.551, 0.278, 9.28}));

TEST(LudingWithoutCohesion, ReturnsTheRootOfTheSlopes) {
  const auto pair = spheres(kRadius, kRadius, 1545);
  const double dt = std::numbers::pi * std::sqrt(pair.effective_mass() / kK1) / 20000;
  auto parameters = kParameters;
  parameters.cohesion = 0;
  const LudingNormal part(parameters, pair);
  for (const double speed : {0.05, 0.2, 0.4}) {
    const auto outcome = collide({.normal = parameters}, pair, speed, dt);
    EXPECT_NEAR(outcome.restitution, std::sqrt(kK1 / part.unloading_slope(outcome.deepest)), 2e-4) << speed;
  }
}

TEST(LudingWithoutCohesion, ReachesThePlasticLimitAtThePublishedSpeed) {
  const auto pair = spheres(kRadius, kRadius, 1545);
  const double dt = std::numbers::pi * std::sqrt(pair.effective_mass() / kK1) / 20000;
  EXPECT_NEAR(collide({.normal = kParameters}, pair, 0.432, dt).deepest / kLimit, 1, 2e-3);
}

TEST(LudingParameters, AreRefusedWhereTheSpringIsNone) {
  EXPECT_THROW(require_sensible({.normal = LudingNormal::Parameters{.loading = 100, .unloading = 100}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine::laws
