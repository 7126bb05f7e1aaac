// JKR: the contact radius against slow solvers over many decades, landmarks, and Hu's anchors.
#include <random>

#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

/// Largest root of a^4 - 2 X a^2 - q a + X^2 = 0: with y = sqrt(a), y^4 - sqrt(q) y - X = 0 has one positive
/// root, bracketed and halved in long double.
double bracketed_root(double X, double q) {
  const long double g = std::sqrt(static_cast<long double>(q)), x = X;
  const auto value = [&](long double y) { return y * (y * y * y - g) - x; };
  long double low = 0, high = std::pow(2 * x, 0.25L) + std::cbrt(2 * g);
  if (high == 0) return 0;
  for (int k = 0; k < 200; ++k) {
    const long double middle = (low + high) / 2;
    (value(middle) > 0 ? high : low) = middle;
  }
  return static_cast<double>(high * high);
}

double newton_root(double X, double q) {
  const double g = std::sqrt(q);
  return jkr_contact_radius_newton(X, g, std::cbrt(2 * g));
}

double worst_error(double (*solver)(double, double)) {
  std::mt19937_64 random(1);
  const auto decade = [&](double low, double high) {
    const double uniform = static_cast<double>(random() >> 11) * 0x1p-53;
    return std::pow(10.0, low + (high - low) * uniform);
  };
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const double radius = decade(-6, -1), modulus = decade(5, 11), gamma = decade(-12, 1);
    const double overlap = k % 10 == 0 ? 0 : radius * decade(-14, std::log10(0.2));
    const double X = radius * overlap, q = 4 * std::numbers::pi * gamma * radius * radius / modulus;
    const double expected = bracketed_root(X, q);
    const double error = std::abs(solver(X, q) / expected - 1);
    worst = std::isfinite(error) ? std::max(worst, error) : kInfinite;
  }
  return worst;
}

TEST(JkrContactRadius, IsTheRootOverTwelveDecades) {
  const double closed = worst_error(jkr_contact_radius), newton = worst_error(newton_root);
  RecordProperty("closed_form_error", std::to_string(closed * 1e15) + "e-15");
  RecordProperty("newton_error", std::to_string(newton * 1e15) + "e-15");
  EXPECT_LT(closed, 1e-14);
  EXPECT_LT(newton, 1e-14);
}

TEST(JkrContactRadius, HasItsLimits) {
  EXPECT_EQ(jkr_contact_radius(0, 0), 0);
  EXPECT_EQ(newton_root(0, 0), 0);
  for (const double X : {1e-24, 1e-12, 1e-3})
    EXPECT_NEAR(jkr_contact_radius(X, 0), std::sqrt(X), 1e-15 * std::sqrt(X));
  for (const double q : {1e-30, 1e-15, 1e-3})
    EXPECT_NEAR(jkr_contact_radius(0, q), std::cbrt(q), 1e-15 * std::cbrt(q));
}

// d = 0.5 mm, E = 10 MPa, nu = 0.3 (Hu 2024, chapter 4).
constexpr double kRadius = 2.5e-4;
const double kModulus = contact_modulus(1e7, 0.3, 1e7, 0.3);

JkrNormal adhesive(double gamma, JkrLoad load = JkrLoad::corrected) {
  return JkrNormal({.modulus = kModulus, .surface_energy = gamma, .load = load}, spheres(kRadius, kRadius));
}
double force_at(const JkrNormal& part, double overlap) {
  return part.force(overlap, std::sqrt(overlap), nullptr).force;
}

TEST(JkrNormalPart, HasHusAnchors) {
  const auto part = adhesive(0.2);
  EXPECT_NEAR(part.pull_off, 2.35619e-4, 1e-9);
  const double a0 = std::cbrt(9 * std::numbers::pi * 0.2 * 1.25e-4 * 1.25e-4 / kModulus);
  EXPECT_NEAR(a0, 2.52409e-5, 1e-10);
  const double equilibrium = a0 * a0 / (3 * 1.25e-4);
  EXPECT_NEAR(equilibrium, 1.69894e-6, 1e-11);
  EXPECT_NEAR(part.contact_radius(equilibrium), a0, 1e-14 * a0 * 10);
  EXPECT_NEAR(force_at(part, equilibrium), 0, 1e-13 * part.pull_off * 10);
  EXPECT_NEAR(part.contact_radius(0) / a0, std::cbrt(4.0 / 9.0), 1e-14);
  EXPECT_NEAR(force_at(part, 0), -8.0 / 9.0 * part.pull_off, 1e-13 * part.pull_off);
  EXPECT_NEAR(part.pull_off / (1000 * std::numbers::pi / 6 * 1.25e-10 * 9.81), 367, 0.5);
}

TEST(JkrNormalPart, NeverPullsHarderThanAtZeroOverlap) {
  const auto part = adhesive(0.2);
  for (int k = 1; k <= 1000; ++k) EXPECT_GT(force_at(part, k * 1e-8), force_at(part, 0));
}

TEST(JkrNormalPart, LoadIsThorntonsOrAsPrinted) {
  const auto corrected = adhesive(0.2), printed = adhesive(0.2, JkrLoad::printed);
  const double a0 = corrected.contact_radius(1.69894e-6);
  const auto check = [&](double x, double good, double bad, double tolerance) {
    const double a = x * a0;
    const double overlap = a * a / 1.25e-4 - std::sqrt(4 * std::numbers::pi * 0.2 * a / kModulus);
    const double clipped = std::max(overlap, 0.0);
    EXPECT_NEAR(corrected.force(clipped, std::sqrt(clipped), nullptr).limit / corrected.pull_off, good,
                tolerance);
    EXPECT_NEAR(printed.force(clipped, std::sqrt(clipped), nullptr).limit / corrected.pull_off, bad,
                tolerance);
  };
  check(0.763, 1.111, 3.111, 1.1e-3);
  check(0.9, 1.501, 4.062, 1e-3);
  check(1, 2.000, 5.000, 1e-3);
  check(1.2, 3.654, 7.597, 1e-3);
  check(1.5, 8.152, 13.663, 1e-3);
}

TEST(JkrNormalPart, FadesIntoHertz) {
  const HertzMindlinNormal hertz({.modulus = kModulus}, spheres(kRadius, kRadius));
  const double expected = hertz.force(1e-6, 1e-3, nullptr).force;
  EXPECT_NEAR(force_at(adhesive(0), 1e-6), expected, 1e-14 * expected);
  double before = kInfinite;
  for (const double gamma : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const double difference = std::abs(force_at(adhesive(gamma), 1e-6) - expected);
    EXPECT_LT(difference, before);
    before = difference;
  }
  EXPECT_LT(before, 1e-3 * expected);
}

TEST(JkrNormalPart, MakeAndBreakConserveEnergy) {
  const auto pair = spheres(kRadius, kRadius);
  const LawParameters law{.normal = JkrNormal::Parameters{.modulus = kModulus, .surface_energy = 0.02}};
  EXPECT_NEAR(collide(law, pair, 0.2, 1e-9).restitution, 1, 1e-3);
}

TEST(JkrNormalPart, SlowDampedSpheresStick) {
  const auto pair = spheres(kRadius, kRadius);
  LawParameters law{.normal = JkrNormal::Parameters{.modulus = kModulus, .surface_energy = 0.2},
                    .load_rule = LoadRule::without};
  law.damping = RestitutionDamping::Parameters{.restitution = 0.1, .modulus = kModulus};
  require_sensible(law);
  const auto outcome = collide(law, pair, 0.01, 1e-7, 20000);
  EXPECT_TRUE(outcome.stuck);
  const double weight_free_rest = 1.69894e-6;
  EXPECT_GT(outcome.deepest, weight_free_rest);
}

TEST(JkrNormalPart, HoldsEightNinthsOfThePullOffForce) {
  // A sphere under a ceiling, pulled by a constant force from where it is at rest, or from touch if it is
  // nowhere.
  const auto wall = sphere_on_wall(kRadius);
  LawParameters law{.normal = JkrNormal::Parameters{.modulus = kModulus, .surface_energy = 0.2},
                    .load_rule = LoadRule::without};
  law.damping = RestitutionDamping::Parameters{.restitution = 0.1, .modulus = kModulus};
  const JkrNormal part({.modulus = kModulus, .surface_energy = 0.2}, wall);
  for (const double share : {0.95, 1.05}) {
    const double pull = share * 8.0 / 9.0 * part.pull_off;
    double low = 0, high = 1e-6;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (force_at(part, middle) < -pull ? low : high) = middle;
    }
    reference::AllPairs<GeneralLaw> pairs({.time_step = 1e-7, .gravity = {0, 0, pull / wall.mass_i}}, {},
                                          [&](const PairProperties& pair) { return make_law(law, pair); });
    reference::Ball ball{.radius = kRadius, .mass = wall.mass_i};
    ball.position = {0, 0, kRadius - high};
    pairs.balls = {ball};
    pairs.planes = {{.normal = {0, 0, 1}}};
    for (int k = 0; k < 20000; ++k) pairs.step();
    EXPECT_EQ(pairs.contacts() == 1, share < 1) << share;
  }
}

}  // namespace
}  // namespace diefill::engine::laws
