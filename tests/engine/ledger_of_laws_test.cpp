// The energy ledger of every law of the sources in a bed that falls and settles: what grains have in motion,
// height and springs, and what laws and walls took, add up.
#include <gtest/gtest.h>

#include <cctype>

#include "engine_test_support.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine {
namespace {

constexpr double kRadius = 2.5e-4, kDensity = 1000;  // m, kg/m^3

/// A loose lattice of spheres that falls onto a plane, periodic in x and y.
Simulation falling_bed(const laws::LawParameters& law, double time_step) {
  constexpr int kAcross = 4, kLayers = 4;
  constexpr double kSpacing = 2.2 * kRadius;
  SimulationSettings settings;
  settings.shape = model_b(kRadius, kDensity * 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius);
  GeneralContact contact;
  contact.grains = contact.walls = law;
  contact.walls.attraction = {};
  settings.general_contact = contact;
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
    grain.angular_velocity = random_vector(random, 100);
    grains.push_back(grain);
  }
  simulation.add_grains(grains);
  return simulation;
}

double error_after(const laws::LawParameters& law, double time_step, double duration) {
  Simulation simulation = falling_bed(law, time_step);
  run_steps(simulation, static_cast<int>(std::lround(duration / time_step)));
  return std::abs(simulation.energy_balance_error());
}

/// Laws whose forces are smooth enough in the overlap for the scheme's second order to show.
std::vector<laws::NamedLaw> smooth_laws() {
  auto all = laws::laws_of_the_sources();
  laws::LawParameters dry = all.front().law, sticky = dry, rolls = dry;
  dry.normal = laws::BierwischNormal::Parameters{};
  dry.rolling = {};
  sticky.rolling = {};
  rolls.normal = laws::BierwischNormal::Parameters{};
  all.front() = {"Bierwisch dry", dry};
  all.push_back({"Bierwisch sticky", sticky});
  all.push_back({"Bierwisch CDT", rolls});
  return all;
}

class LedgerOfLaws : public ::testing::TestWithParam<laws::NamedLaw> {};

TEST_P(LedgerOfLaws, ClosesWithTheSquareOfTheStep) {
  constexpr double kStep = 1e-6, kFiner = 8, kSettled = 0.02;  // s
  const double coarse = error_after(GetParam().law, kStep, kSettled);
  const double fine = error_after(GetParam().law, kStep / kFiner, kSettled);
  std::printf("%s %.3e %.3e\n", GetParam().name.c_str(), coarse, fine); std::fflush(stdout);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / std::pow(kFiner, 1.6));
}

INSTANTIATE_TEST_SUITE_P(Sources, LedgerOfLaws, ::testing::ValuesIn(smooth_laws()), [](const auto& instance) {
  std::string name = instance.param.name;
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
  return name;
});

}  // namespace
}  // namespace diefill::engine
