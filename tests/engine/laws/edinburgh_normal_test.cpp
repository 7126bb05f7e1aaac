// The Edinburgh elasto-plastic adhesion law over load cycles and in collisions, both branches, against its
// closed forms.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

constexpr double kRadius = 1e-3, kRatio = 0.6, kPullOff = 2e-4, kSurface = 5, kDeepest = 2e-5;

EdinburghNormal::Parameters parameters_of(EdinburghBranch branch) {
  return {.branch = branch,
          .modulus = 5e6,
          .stiffness = 500,
          .plasticity_ratio = kRatio,
          .pull_off = kPullOff,
          .surface_energy = kSurface};
}

class EdinburghCycle : public ::testing::TestWithParam<EdinburghBranch> {
 protected:
  PairProperties pair = spheres(kRadius, kRadius, 2500);
  EdinburghNormal::Parameters given = parameters_of(GetParam());
  EdinburghNormal part{given, pair};
  double n = GetParam() == EdinburghBranch::linear ? 1 : 1.5;
  double k1 = GetParam() == EdinburghBranch::linear ? 500 : 4.0 / 3.0 * 5e6 * std::sqrt(0.5 * kRadius);
  double k2 = k1 / (1 - kRatio);
  double plastic = std::pow(kRatio, 1 / n) * kDeepest;  ///< m, h_p
  double least = 1.5 * std::numbers::pi * kSurface *
                 std::sqrt(2 * plastic * 0.5 * kRadius - plastic * plastic);  ///< N, f_min
  double least_at = std::pow(std::pow(plastic, n) - (least - kPullOff) / k2, 1 / n);
  double k_adh = (least - kPullOff) / std::pow(least_at, n);
  double history[2] = {};
  double work = 0;

  StaticForce at(double overlap) { return part.force(overlap, std::sqrt(std::max(overlap, 0.0)), history); }
  /// Moves in small steps to `overlap` and returns the force there; adds to the work done on the spheres.
  double go(double from, double to, int steps = 4000) {
    double before = from > 0 ? at(from).force : -kPullOff, now = before;
    for (int k = 1; k <= steps; ++k) {
      now = at(from + (to - from) * k / steps).force;
      work += 0.5 * (before + now) * (to - from) / steps;
      before = now;
    }
    return now;
  }
  double line(double h) const { return -kPullOff + k2 * (std::pow(h, n) - std::pow(plastic, n)); }
  double scale() const { return k1 * std::pow(kDeepest, n); }
};

TEST_P(EdinburghCycle, BeginsAtThePullOffForceAndLoadsAlongTheSoftBranch) {
  EXPECT_NEAR(at(1e-18).force, -kPullOff, 1e-9 * kPullOff);
  for (const double share : {0.1, 0.5, 1.0}) {
    const double h = share * kDeepest;
    EXPECT_NEAR(at(h).force, -kPullOff + k1 * std::pow(h, n), 1e-12 * scale());
  }
}

TEST_P(EdinburghCycle, UnloadsAlongTheStiffBranchAndReloadingRetracesIt) {
  go(0, kDeepest);
  for (const double share : {0.9, 0.95, 0.85, 0.9, 0.99}) {
    const double h = share * kDeepest;
    EXPECT_NEAR(at(h).force, line(h), 1e-12 * scale());
  }
  EXPECT_NEAR(at(plastic).force, -kPullOff, 1e-10 * scale());
  // Beyond the old turning point first loading goes on.
  EXPECT_NEAR(at(1.1 * kDeepest).force, -kPullOff + k1 * std::pow(1.1 * kDeepest, n), 1e-12 * scale());
}

TEST_P(EdinburghCycle, ReachesTheMinimumForceOfTheSurfaceEnergyThenFollowsTheLimb) {
  go(0, kDeepest);
  ASSERT_GT(least, kPullOff);
  ASSERT_LT(least - kPullOff, 0.5 * k2 * std::pow(plastic, n));
  EXPECT_NEAR(at(least_at * (1 + 1e-9)).force, -least, 1e-6 * least);
  for (const double share : {0.9, 0.5, 0.1}) {
    const double h = share * least_at;
    const auto force = at(h);
    EXPECT_NEAR(force.force, -kPullOff - k_adh * std::pow(h, n), 1e-9 * least);
    EXPECT_NEAR(force.limit, 0, 1e-12 * scale());
  }
  EXPECT_NEAR(at(1e-18).force, -kPullOff, 1e-9 * kPullOff);
}

TEST_P(EdinburghCycle, LeavesTheLimbAlongTheStiffBranch) {
  go(0, kDeepest);
  const double h = 0.5 * least_at, here = go(kDeepest, h), step = 1e-3 * h;
  const double expected = here + k2 * (std::pow(h + step, n) - std::pow(h, n));
  EXPECT_NEAR(at(h + step).force, expected, 1e-10 * scale());
  EXPECT_NEAR(at(h).force, here, 1e-10 * scale());  // and comes back to it
  EXPECT_NEAR(at(h + step).limit, expected + kPullOff + k_adh * std::pow(h + step, n), 1e-9 * scale());
}

TEST_P(EdinburghCycle, LosesTheAreaBetweenItsBranches) {
  const auto area_below = [&](double coefficient, double h) {
    return coefficient * std::pow(h, n + 1) / (n + 1);
  };
  go(0, kDeepest, 40000);
  const double stored = part.energy(kDeepest, history);
  const double taken = work;
  EXPECT_NEAR(taken, area_below(k1, kDeepest) - kPullOff * kDeepest, 1e-6 * taken);
  go(kDeepest, plastic, 40000);
  EXPECT_NEAR(taken - work, stored - part.energy(plastic, history), 1e-6 * taken);
  go(plastic, least_at, 40000);
  go(least_at, 0, 40000);
  // f_0 is conservative; what is lost lies between k_1 and k_2 above, and k_2 and the adhesive branch below.
  const double given_back =
      area_below(k2, kDeepest) - area_below(k2, least_at) - k2 * std::pow(plastic, n) * (kDeepest - least_at);
  const double lost = area_below(k1, kDeepest) - given_back + area_below(k_adh, least_at);
  EXPECT_NEAR(work, lost, 2e-5 * taken);
}

TEST_P(EdinburghCycle, NeverYieldsEnergyOverAnyTurns) {
  double here = 0, least_lost = 0;
  for (const double turn : {0.5, 0.1, 1.0, 0.3, 0.6, 0.02, 0.05, 0.01, 1.4, 0.7, 0.65, 0.2, 1.6, 0.0}) {
    go(here, turn * kDeepest);
    here = turn * kDeepest;
    const double lost = work - (here > 0 ? part.energy(here, history) : 0);
    EXPECT_GE(lost, least_lost - 1e-6 * scale() * kDeepest) << turn;
    least_lost = lost;
  }
}

TEST_P(EdinburghCycle, KeepsTheLimbNoSteeperThanTheStiffBranch) {
  given.surface_energy = 100;  // f_min beyond what the plastic overlap bears
  const EdinburghNormal sticky(given, pair);
  sticky.force(kDeepest, std::sqrt(kDeepest), history);
  EXPECT_NEAR(history[1], k2, 1e-9 * k2);
  const double corner = std::pow(0.5 * std::pow(plastic, n), 1 / n);
  EXPECT_NEAR(sticky.force(corner, std::sqrt(corner), history).force,
              -kPullOff - 0.5 * k2 * std::pow(plastic, n), 1e-9 * scale());
}

TEST_P(EdinburghCycle, WithoutSurfaceEnergyOnlyThePullOffForceHolds) {
  given.surface_energy = 0;
  const EdinburghNormal weak(given, pair);
  weak.force(kDeepest, std::sqrt(kDeepest), history);
  for (const double share : {0.9, 0.5, 0.1}) {
    const double h = share * plastic;
    EXPECT_DOUBLE_EQ(weak.force(h, std::sqrt(h), history).force, -kPullOff);
  }
}

TEST_P(EdinburghCycle, WithoutPlasticityIsTheElasticSpring) {
  given.plasticity_ratio = given.pull_off = given.surface_energy = 0;
  const EdinburghNormal elastic(given, pair);
  for (const double h : {1.0, 0.4, 0.7, 0.1}) {
    const double overlap = h * kDeepest, force = k1 * std::pow(overlap, n);
    EXPECT_NEAR(elastic.force(overlap, std::sqrt(overlap), history).force, force, 1e-12 * scale());
    EXPECT_NEAR(elastic.energy(overlap, history), force * overlap / (n + 1), 1e-12 * scale() * kDeepest);
  }
}

TEST_P(EdinburghCycle, AsksForTheTimeStepOfTheStiffBranch) {
  const double step = 1e-6 * kDeepest;
  EXPECT_NEAR(part.stiffness(kDeepest, history), (line(kDeepest + step) - line(kDeepest - step)) / (2 * step),
              1e-6 * part.stiffness(kDeepest, history));
}

TEST_P(EdinburghCycle, IsSimilarAtAnyScale) {
  constexpr double kScale = 7;
  const EdinburghNormal large(given.similar(kScale), spheres(kScale * kRadius, kScale * kRadius));
  double other[2] = {};
  for (const double h : {0.3, 1.0, 0.8, 0.5, 0.2, 0.25, 0.05, 0.9}) {
    const double overlap = h * kDeepest, grown = kScale * overlap;
    const auto small = at(overlap), big = large.force(grown, std::sqrt(grown), other);
    EXPECT_NEAR(big.force, kScale * kScale * small.force, 1e-10 * kScale * kScale * scale()) << h;
    EXPECT_NEAR(big.limit, kScale * kScale * small.limit, 1e-10 * kScale * kScale * scale()) << h;
  }
}

TEST_P(EdinburghCycle, GivesBackTheRootOfTheStiffnessesWithoutAdhesion) {
  given.pull_off = given.surface_energy = 0;
  // Energy over the unloading line: n = 1 k_1 / k_2; n = 3/2 by integration of the same closed form.
  const double plastic_share = std::pow(kRatio, 1 / n);
  const double back = (1 - std::pow(plastic_share, n + 1)) / (n + 1) - kRatio * (1 - plastic_share);
  const double expected = std::sqrt(back * (n + 1) / (1 - kRatio));
  double before = 1;
  for (const double step : {4e-7, 2e-7, 1e-7}) {
    const auto outcome = collide({.normal = given}, pair, 0.2, step);
    const double error = std::abs(outcome.restitution - expected);
    EXPECT_LT(error, 2e-2);
    EXPECT_LT(error, before + 1e-4) << step;
    before = error;
  }
  EXPECT_LT(before, 5e-3);
}

TEST_P(EdinburghCycle, SlowSpheresStickAndFastOnesReboundSlowerAtAnyStep) {
  for (const double step : {8e-7, 4e-7, 2e-7})
    EXPECT_TRUE(collide({.normal = given}, pair, 0.03, step, 100000).stuck) << step;
  for (const double speed : {0.2, 0.5}) {
    const auto finest = collide({.normal = given}, pair, speed, 1e-7);
    EXPECT_GT(finest.restitution, 0.3);
    EXPECT_LT(finest.restitution, 0.6);
    for (const double step : {8e-7, 4e-7, 2e-7})
      EXPECT_NEAR(collide({.normal = given}, pair, speed, step).restitution, finest.restitution, 2e-4)
          << step;
  }
}

INSTANTIATE_TEST_SUITE_P(Branches, EdinburghCycle,
                         ::testing::Values(EdinburghBranch::linear, EdinburghBranch::hertzian));

TEST(EdinburghParameters, AreRefusedWhereTheyMakeNoSense) {
  for (const auto& wrong :
       {EdinburghNormal::Parameters{.plasticity_ratio = 1}, EdinburghNormal::Parameters{.pull_off = -1},
        EdinburghNormal::Parameters{.surface_energy = std::nan("")},
        EdinburghNormal::Parameters{.modulus = 0},
        EdinburghNormal::Parameters{.branch = EdinburghBranch::linear, .stiffness = 0}})
    EXPECT_THROW(require_sensible({.normal = wrong}), std::invalid_argument);
  EXPECT_THROW(require_sensible({.normal = EdinburghNormal::Parameters{.surface_energy = 0.01},
                                 .attraction = VanDerWaals::Parameters{.hamaker = 1e-19}}),
               std::invalid_argument);
  EXPECT_NO_THROW(require_sensible(
      {.normal = EdinburghNormal::Parameters{.branch = EdinburghBranch::linear, .stiffness = 80},
       .damping = LinearRestitutionDamping::Parameters{.stiffness = 80}}));
}

}  // namespace
}  // namespace diefill::engine::laws
