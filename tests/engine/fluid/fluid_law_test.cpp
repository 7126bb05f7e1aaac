// Law and random numbers of a fluid of particles against exact results.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/laws/dissipative_particles.h"
#include "engine/numerics/pair_random.h"

namespace diefill::engine {
namespace {

using laws::DissipativeParticles;
using laws::DpdParameters;

// Known answers of the generator's authors.
TEST(PairRandom, GivesTheKnownBits) {
  const std::array<std::uint32_t, 4> of_zero = {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8};
  const std::array<std::uint32_t, 4> of_ones = {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd};
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), of_zero);
  constexpr std::uint32_t kOnes = 0xffffffff;
  EXPECT_EQ(philox({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}), of_ones);
}

TEST(PairRandom, IsGaussianAndTheSameFromBothSides) {
  const PairRandom random(7, 1234567890123);
  constexpr int kCount = 400000;
  double sum = 0, squares = 0, fourth = 0;
  for (std::uint64_t k = 0; k < kCount; ++k) {
    const double zeta = random.gaussian(k, 3 * k + 1);
    ASSERT_EQ(zeta, random.gaussian(3 * k + 1, k));
    sum += zeta;
    squares += zeta * zeta;
    fourth += zeta * zeta * zeta * zeta;
  }
  EXPECT_NEAR(sum / kCount, 0, 5 / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, 1, 5 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(fourth / kCount, 3, 5 * std::sqrt(96.0 / kCount));
}

TEST(PairRandom, DiffersBetweenPairsStepsAndSeeds) {
  const double zeta = PairRandom(1, 1).gaussian(2, 3);
  EXPECT_NE(zeta, PairRandom(1, 1).gaussian(2, 4));
  EXPECT_NE(zeta, PairRandom(1, 2).gaussian(2, 3));
  EXPECT_NE(zeta, PairRandom(2, 1).gaussian(2, 3));
  EXPECT_NE(zeta, PairRandom(1, 1 + (std::uint64_t{1} << 32U)).gaussian(2, 3));
}

TEST(DissipativeParticles, KernelAddsUpToOneOverSpace) {
  DpdParameters parameters;
  parameters.reach = 1.7;
  const DissipativeParticles law(parameters, 0.01);
  constexpr int kShells = 100000;
  double sum = 0;
  for (int k = 0; k < kShells; ++k) {
    const double r = parameters.reach * (k + 0.5) / kShells;
    sum += 4 * std::numbers::pi * r * r * law.density_of(law.weight(r)) * parameters.reach / kShells;
  }
  EXPECT_NEAR(sum, 1, 1e-8);
}

// Eq. A.1 is the slope of the sum of psi over all particles.
TEST(DissipativeParticles, RepulsionIsTheSlopeOfItsEnergy) {
  const DissipativeParticles law({}, 0.01);
  constexpr double kOthers[] = {3.1, 5.2};  // 1/r_c^3, density about each of two by others
  const auto energy = [&](double r) {
    double sum = 0;
    for (const double others : kOthers) sum += law.energy(others + law.density_of(law.weight(r)));
    return sum;
  };
  for (const double r : {0.1, 0.4, 0.8}) {
    constexpr double kStep = 1e-5;
    const double slope = (energy(r + kStep) - energy(r - kStep)) / (2 * kStep), w = law.weight(r);
    double pushes = 0;
    for (const double others : kOthers) pushes += law.push(others + law.density_of(w));
    EXPECT_NEAR(law.between_fluid(w, pushes, 0), -slope, 1e-6 * std::abs(slope)) << r;
  }
}

TEST(DissipativeParticles, DampingFollowsFromTheNoise) {
  const DissipativeParticles law({}, 0.01);
  EXPECT_DOUBLE_EQ(law.damping(), 4.5);  // sigma_R = 3 (Table C.7)
  EXPECT_DOUBLE_EQ(law.between_fluid(0.5, 0, 2), -4.5 * 0.25 * 2);
  EXPECT_DOUBLE_EQ(law.kick_in_fluid(0.5, 1), 3 * 0.5 / 0.1);
}

TEST(DissipativeParticles, SolidsAreElastic) {
  const DissipativeParticles law({}, 0.01);
  EXPECT_DOUBLE_EQ(law.between_grains(0.25), 1e3 * 0.125);
  EXPECT_DOUBLE_EQ(law.at_tool(0.25, 0), 1e3 * 0.125);
  EXPECT_DOUBLE_EQ(law.at_tool(0.25, 2), 1e3 * 0.125 - 10 * 0.5 * 2);
  EXPECT_EQ(law.at_tool(0.25, 1e6), 0);
}

TEST(DissipativeParticles, RefuseConstantsThatMakeNoFluid) {
  const auto law_of = [](auto change) {
    DpdParameters parameters;
    change(parameters);
    return DissipativeParticles(parameters, 0.01);
  };
  EXPECT_THROW(law_of([](auto& given) { given.reach = 0; }), std::invalid_argument);
  EXPECT_THROW(law_of([](auto& given) { given.thermal_energy = 0; }), std::invalid_argument);
  EXPECT_THROW(law_of([](auto& given) { given.noise = -1; }), std::invalid_argument);
  EXPECT_THROW(law_of([](auto& given) { given.solid_share = 0; }), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
