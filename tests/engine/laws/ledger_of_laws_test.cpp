// The energy ledger of every law of the sources in a bed that falls and settles: what grains have in motion,
// height and springs, and what laws and walls took, add up.
#include <gtest/gtest.h>

#include <cctype>

#include "engine/observe/energy_balance.h"
#include "tests/engine/engine_test_support.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine {
namespace {

constexpr double kRadius = 2.5e-4, kDensity = 1000;  // m, kg/m^3

using Model = GrainShape (*)(double radius, double mass);

/// A loose lattice of spheres that falls onto a plane, periodic in x and y.
Simulation falling_bed(const laws::LawParameters& law, double time_step, Model model = model_b) {
  constexpr int kAcross = 4, kLayers = 4;
  constexpr double kSpacing = 2.2 * kRadius;
  SimulationSettings settings;
  settings.types = {{model(kRadius, kDensity * 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius)}};
  GeneralContact contact;
  contact.grains = contact.walls = law;
  contact.walls.attraction = {};
  settings.contact = contact;
  settings.time_step = time_step;
  settings.period = {kAcross * kSpacing, kAcross * kSpacing};
  WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  Simulation simulation(settings, {floor});
  std::mt19937_64 random(2);
  std::vector<NewGrain> grains;
  for (int k = 0; k < kAcross * kAcross * kLayers; ++k) {
    NewGrain grain;
    grain.position =
        kSpacing * Eigen::Vector3d(k % kAcross, k / kAcross % kAcross, k / kAcross / kAcross + 0.6) +
        random_vector(random, 0.05 * kRadius);
    grain.velocity = random_vector(random, 0.05);
    if (model == model_b) grain.angular_velocity = random_vector(random, 100);
    grains.push_back(grain);
  }
  simulation.add_grains(grains);
  return simulation;
}

double error_after(const laws::LawParameters& law, double time_step, double duration) {
  Simulation simulation = falling_bed(law, time_step);
  run_steps(simulation, static_cast<int>(std::lround(duration / time_step)));
  return std::abs(energy_balance_error(simulation));
}

/// All laws of the sources but the first, Bierwisch's.
std::vector<laws::NamedLaw> laws_after_bierwisch() {
  auto all = laws::laws_of_the_sources();
  all.erase(all.begin());
  return all;
}

constexpr double kStep = 1e-6, kFiner = 8;  // s

class LedgerOfLaws : public ::testing::TestWithParam<laws::NamedLaw> {};

TEST_P(LedgerOfLaws, ClosesWithTheSquareOfTheStep) {
  constexpr double kSettled = 0.02;  // s
  const double coarse = error_after(GetParam().law, kStep, kSettled);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(error_after(GetParam().law, kStep / kFiner, kSettled), coarse / std::pow(kFiner, 1.6));
}

INSTANTIATE_TEST_SUITE_P(Sources, LedgerOfLaws, ::testing::ValuesIn(laws_after_bierwisch()),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           for (char& letter : name)
                             if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
                           return name;
                         });

// Grains that do not turn have no spins, which these laws multiply torques with.
TEST(LedgerOfSpheresThatDoNotTurn, ClosesAndIsNoEmptySum) {
  for (const auto& named : laws::laws_of_the_sources()) {
    laws::LawParameters law = named.law;
    law.rolling = {};
    Simulation simulation = falling_bed(law, kStep, model_a);
    run_steps(simulation, 20000);
    EXPECT_EQ(simulation.ledger().rolling_work, 0) << named.name;
    const double error = energy_balance_error(simulation);
    EXPECT_LT(std::abs(error), 1e-3) << named.name;
    EXPECT_NE(error, 0) << named.name;
  }
}

// Cohesion begins with an infinite slope at touch: less than second order.
TEST(LedgerOfBierwischsLaw, ClosesWithTheStep) {
  const auto sticky = laws::laws_of_the_sources().front().law;
  constexpr double kFalling = 0.005;  // s
  const double coarse = error_after(sticky, kStep, kFalling);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(error_after(sticky, kStep / kFiner, kFalling), 0.5 * coarse);
}

}  // namespace
}  // namespace diefill::engine
