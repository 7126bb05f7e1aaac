// Any law of the sources in the engine: compared with the slow reference of all pairs, with the engine's
// own tuned law, on one and two threads, and with a restart in between.
#include <gtest/gtest.h>

#include "engine/coarse_graining/methods.h"
#include "tests/engine/engine_test_support.h"
#include "tests/engine/laws/source_laws.h"
#include "tests/engine/reference/all_pairs.h"

namespace diefill::engine {
namespace {

constexpr double kRadius = 2.5e-4, kDensity = 1000;

SimulationSettings settings_for(const laws::LawParameters& law, const std::string& method, double scale,
                                double time_step) {
  SimulationSettings settings;
  settings.types = {
      {model_b(kRadius, kDensity * 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius)}};
  GeneralContact contact;
  contact.grains = contact.walls = law;
  contact.walls.attraction = {};
  contact.scaling = coarse_graining::force_scaling(method, scale);
  settings.contact = contact;
  settings.time_step = time_step;
  return settings;
}

/// Spinning spheres that fly at each other and at the floor.
std::vector<NewGrain> cluster(double speed) {
  std::mt19937_64 random(3);
  std::vector<NewGrain> grains;
  for (int k = 0; k < 12; ++k) {
    const Eigen::Vector3d corner(k % 2 - 0.5, k / 2 % 2 - 0.5, k / 4 + 0.6);
    NewGrain grain;
    grain.position = 2.1 * kRadius * (corner + random_vector(random, 0.03));
    grain.velocity = speed * Eigen::Vector3d(-corner.x(), -corner.y(), -0.5 * corner.z());
    grain.angular_velocity = random_vector(random, 0.5 * speed / kRadius);
    grains.push_back(grain);
  }
  return grains;
}

WallBodySpec floor() {
  WallBodySpec body;
  body.name = "floor";
  body.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  return body;
}

using GeneralReference = reference::AllPairs<coarse_graining::ScaledLaw<laws::GeneralLaw>>;

GeneralReference reference_for(const SimulationSettings& settings, const std::vector<NewGrain>& grains) {
  reference::Settings same;
  same.time_step = settings.time_step;
  same.gravity = plain(settings.gravity);
  same.arm = reference::Arm::surface;
  const auto& contact = settings.contact;
  same.torque_factor = contact.scaling.torque_factor();
  const auto maker = [scaling = contact.scaling](const laws::LawParameters& law) {
    return [scaling, law](const laws::PairProperties& pair) {
      return coarse_graining::ScaledLaw<laws::GeneralLaw>(scaling,
                                                          laws::make_law(law, scaling.original(pair)));
    };
  };
  GeneralReference reference(same, maker(contact.between(kPowderMaterial, kPowderMaterial)),
                             maker(contact.between(kPowderMaterial, kWallMaterial)));
  for (const auto& grain : grains)
    reference.balls.push_back({.radius = kRadius,
                               .mass = settings.shape().mass,
                               .position = plain(grain.position),
                               .velocity = plain(grain.velocity),
                               .spin = plain(grain.angular_velocity)});
  reference.planes.push_back({.point = {}, .normal = {0, 0, 1}});
  return reference;
}

using Case = laws::ScaledCase;

class GeneralContactLaws : public ::testing::TestWithParam<Case> {};

/// Largest difference between engine and reference after `duration` (s), over kRadius and the speed of
/// impact.
double difference(const Case& given, double time_step, double duration, std::uint64_t& touched) {
  constexpr double kSpeed = 0.3;
  const auto settings = settings_for(given.law.law, given.method, given.scale, time_step);
  const auto grains = cluster(kSpeed);
  Simulation simulation(settings, {floor()});
  simulation.add_grains(grains);
  auto reference = reference_for(settings, grains);
  for (int k = 0; k < static_cast<int>(std::lround(duration / time_step)); ++k) {
    simulation.step();
    reference.step();
    touched = std::max(touched, simulation.touching_pairs());
  }
  double most = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& ball = reference.balls[k];
    const Eigen::Vector3d spin = simulation.angular_velocity(place_of(simulation, k)) - eigen(ball.spin);
    most = std::max({most, (position_of(simulation, k) - eigen(ball.position)).norm() / kRadius,
                     (velocity_of(simulation, k) - eigen(ball.velocity)).norm() / kSpeed,
                     kRadius * spin.norm() / kSpeed});
  }
  return most;
}

TEST_P(GeneralContactLaws, EngineMovesGrainsAsAllPairsDo) {
  // The reference sees forces with velocities of the half step, the engine with predicted ones: both meet as
  // the time step goes to nothing.
  std::uint64_t touched = 0;
  const double coarse = difference(GetParam(), 2e-8, 6e-5, touched);
  const double fine = difference(GetParam(), 5e-9, 6e-5, touched);
  EXPECT_GE(touched, 2U);
  EXPECT_LT(fine, 2e-4);
  EXPECT_LT(fine, 0.5 * coarse);
}

TEST_P(GeneralContactLaws, ThreadsAndRestartChangeNoBit) {
  auto settings = settings_for(GetParam().law.law, GetParam().method, GetParam().scale, 1e-7);
  const auto grains = cluster(0.3);
  Simulation unbroken(settings, {floor()});
  unbroken.add_grains(grains);
  settings.threads = 2;
  Simulation broken(settings, {floor()});
  broken.add_grains(grains);
  run_steps(unbroken, 4000);
  run_steps(broken, 1500);
  ASSERT_FALSE(broken.snapshot().grain_history.pair.empty());
  Simulation resumed(settings, {floor()});
  resumed.restore(broken.snapshot());
  run_steps(resumed, 2500);
  EXPECT_EQ(resumed.hash(), unbroken.hash());
}

TEST_P(GeneralContactLaws, InstructionSetsGiveTheSameBits) {
  auto settings = settings_for(GetParam().law.law, GetParam().method, GetParam().scale, 1e-7);
  std::vector<std::uint64_t> hashes;
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    settings.instructions = set;
    Simulation simulation(settings, {floor()});
    simulation.add_grains(cluster(0.3));
    run_steps(simulation, 3000);
    hashes.push_back(simulation.hash());
  }
  for (const auto hash : hashes) EXPECT_EQ(hash, hashes.front());
}

INSTANTIATE_TEST_SUITE_P(Sources, GeneralContactLaws,
                         ::testing::ValuesIn(laws::laws_under({"scaled-up particle",
                                                               "Hu chapter 4 method 2"})),
                         [](const auto& instance) {
                           std::string name = instance.param.law.name + "_" + instance.param.method;
                           for (char& letter : name)
                             if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
                           return name;
                         });

TEST(GeneralContact, BierwischPutTogetherIsTheTunedLaw) {
  // Model D clumps with friction and cohesion: once through the loop of its own, once through the one for
  // laws of any parts, which several types go through, as if they were alike.
  auto tuned = weightless(Model::d, {.friction = 0.5, .work_of_adhesion = 0.01}, 1e-6);
  auto general = tuned;
  general.types.push_back(general.types.front());
  Simulation one(tuned, {}), other(general, {});
  for (auto* simulation : {&one, &other}) {
    simulation->add_grains(converging_cloud({3, 3, 3}, 2 * half_size(tuned.shape()), 0.3, 8));
    run_steps(*simulation, 400);
  }
  EXPECT_GT(one.touching_pairs(), 10U);
  EXPECT_EQ(one.touching_pairs(), other.touching_pairs());
  for (std::uint64_t id = 0; id < one.grains().size(); ++id)
    EXPECT_LT((position_of(one, id) - position_of(other, id)).norm(), 1e-9 * half_size(tuned.shape())) << id;
}

TEST(GeneralContact, VanDerWaalsPullsBeforeTouch) {
  laws::LawParameters law;
  law.attraction = laws::VanDerWaals::Parameters{.hamaker = 5e-18};
  auto settings = settings_for(law, "none", 1, 1e-7);
  settings.gravity.setZero();
  const double range = laws::make_law(law, {kRadius, kRadius, 1, 1}).range();
  ASSERT_GT(range, 0);
  for (const double gap : {0.5 * range, 1.5 * range}) {
    Simulation simulation(settings, {});
    std::vector<NewGrain> grains(2);
    grains[1].position.x() = 2 * kRadius + gap;
    simulation.add_grains(grains);
    run_steps(simulation, 5);
    if (gap < range)
      EXPECT_GT(velocity_of(simulation, 0).x(), 0);
    else
      EXPECT_EQ(velocity_of(simulation, 0).x(), 0);
    EXPECT_EQ(simulation.touching_pairs(), 0U);
  }
}

TEST(GeneralContact, RefusesWallsThatAttractFromAfar) {
  laws::LawParameters law;
  law.attraction = laws::VanDerWaals::Parameters{.hamaker = 5e-18};
  auto settings = settings_for(law, "none", 1, 1e-7);
  EXPECT_NO_THROW(Simulation(settings, {floor()}));
  law_in(settings, kPowderMaterial, kWallMaterial).attraction =
      laws::VanDerWaals::Parameters{.hamaker = 5e-18, .walls_at_distance = true};
  EXPECT_THROW(Simulation(settings, {floor()}), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
