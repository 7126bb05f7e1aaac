// Cohesion: the minimum of Hertz plus JKR term (Bierwisch 2009, Eq. 2.5) and grains that hang on each other.
#include <gtest/gtest.h>

#include "engine/laws/contact_law.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

using CohesiveLaw = laws::ContactLaw<laws::HertzianCohesion, laws::NoFriction>;

constexpr double kAdhesion = 0.01, kModulus = 1e7, kEffectiveRadius = 3.92e-5;

CohesiveLaw law() {
  return {ContactParameters{.reduced_modulus = kModulus, .work_of_adhesion = kAdhesion}, kEffectiveRadius};
}

double static_force(double overlap) {
  return law().normal(overlap, std::sqrt(overlap), 0).total();
}

/// Overlap where the force is smallest, by golden section between 0 and `upper`.
double overlap_of_minimum(double upper) {
  double low = 0, high = upper;
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  while (high - low > 1e-9 * upper) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (static_force(left) < static_force(right))
      high = right;
    else
      low = left;
  }
  return 0.5 * (low + high);
}

TEST(Cohesion, ForceHasThePublishedMinimum) {
  const double at = overlap_of_minimum(1e-6);
  EXPECT_NEAR(static_force(at), -1.5 * std::numbers::pi * kAdhesion * kEffectiveRadius, 1e-15);
  EXPECT_NEAR(static_force(at), -1.8473e-6, 1e-10);
  EXPECT_NEAR(at, 1.2513e-7, 1e-3 * 1.2513e-7);
  const double closed =
      std::pow(2.25 * std::numbers::pi * kAdhesion / kModulus * std::sqrt(kEffectiveRadius), 2.0 / 3.0);
  EXPECT_NEAR(at, closed, 1e-6 * closed);
}

TEST(Cohesion, ForceVanishesWhereRepulsionBalancesIt) {
  const double balance = std::pow(2.0, 4.0 / 3.0) * overlap_of_minimum(1e-6);
  EXPECT_NEAR(static_force(balance), 0, 1e-11);
  EXPECT_LT(static_force(0.99 * balance), 0);
  EXPECT_GT(static_force(1.01 * balance), 0);
}

TEST(Cohesion, EnergyIsIntegralOfForce) {
  for (const double overlap : {1e-8, 1e-7, 1e-6}) {
    const double step = 1e-4 * overlap;
    const double slope = (law().energy(overlap + step) - law().energy(overlap - step)) / (2 * step);
    EXPECT_NEAR(slope, static_force(overlap), 1e-6 * std::abs(static_force(overlap)) + 1e-13);
  }
}

TEST(Cohesion, FrictionLoadLeavesCohesionOut) {
  const double balance = std::pow(2.0, 4.0 / 3.0) * overlap_of_minimum(1e-6);
  const auto normal = law().normal(balance, std::sqrt(balance), 0);
  EXPECT_NEAR(normal.load(), laws::Hertz(kModulus, kEffectiveRadius).force(balance, std::sqrt(balance)),
              1e-20);
  EXPECT_GT(normal.load(), 1e-6);
}

TEST(Cohesion, StuckGrainsComeToRestAtBalance) {
  // Two D1 grains laid tip to tip with no speed: cohesion pulls them together, damping brings them to rest.
  const auto settings = weightless(Model::d, {.work_of_adhesion = 0.15}, 1e-6);
  Simulation simulation(settings, {});
  const double half = half_size(settings.shape) - 1e-9;
  NewGrain left, right;
  left.position = {-half, 0, 0};
  right.position = {half, 0, 0};
  simulation.add_grains({left, right});
  run_steps(simulation, 5000);
  const double closed =
      std::pow(2.25 * std::numbers::pi * 0.15 / kModulus * std::sqrt(0.5 * settings.shape.sphere_radius),
               2.0 / 3.0) *
      std::pow(2.0, 4.0 / 3.0);
  EXPECT_NEAR(simulation.deepest_overlap(), closed, 1e-6 * closed);
}

TEST(Cohesion, PullOffForceIsThatOfTheMinimum) {
  // A grain is drawn away from a sticky plane by its weight.
  auto settings = weightless(Model::a, {}, 1e-6);
  settings.wall_contact.work_of_adhesion = 0.01;
  const double effective = effective_radius(settings.shape.sphere_radius, 100);
  const double pull_off = 1.5 * std::numbers::pi * 0.01 * effective;
  const double critical_gravity = pull_off / settings.shape.mass;
  for (const double share : {0.95, 1.05}) {
    settings.gravity = {0, 0, share * critical_gravity};
    Simulation simulation(settings, {plane_wall()});
    NewGrain grain;
    const double closed = std::pow(
        2.25 * std::numbers::pi * 0.01 / settings.wall_contact.reduced_modulus * std::sqrt(effective),
        2.0 / 3.0);
    grain.position = {0, 0, settings.shape.sphere_radius - 1.3 * closed};
    simulation.add_grains({grain});
    run_steps(simulation, 4000);
    const bool stuck = position_of(simulation, 0).z() < settings.shape.sphere_radius;
    EXPECT_EQ(stuck, share < 1) << share;
  }
}

}  // namespace
}  // namespace diefill::engine
