// The history of contacts whose laws are exchanged while a simulation runs.
#include <gtest/gtest.h>

#include <map>

#include "tests/engine/contact_energy.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

constexpr double kRadius = 1.5e-4, kMass = 7.63e-8, kTimeStep = 1e-7;  // m, kg, s
constexpr std::size_t kFrictionAt = laws::GeneralLaw::kFrictionHistory,
                      kRollingAt = laws::GeneralLaw::kRollingHistory;

/// A law whose normal, friction and rolling part have a history.
laws::LawParameters with_history() {
  laws::LawParameters law;
  law.normal = laws::LudingNormal::Parameters{.loading = 100, .unloading = 500};
  law.friction = laws::CundallFriction::Parameters{.tangential = 50, .friction = 0.5};
  law.rolling = laws::Epsd2Rolling::Parameters{.rolling_friction = 0.3, .shear_modulus = 1e6};
  return law;
}

/// Histories of touching pairs, by the numbers of both grains, or of a grain and kWall.
using Memories = std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<double>>;
constexpr std::uint64_t kWall = 99;

Memories memories_of(const Simulation& simulation) {
  constexpr auto kWidth = static_cast<std::size_t>(laws::GeneralLaw::kHistory);
  const auto id = [&](std::size_t sphere) { return simulation.grains().id[sphere]; };
  Memories memories;
  for (const Block& block : simulation.neighbours().blocks())
    block.wall_pairs.visit_touching([&](std::size_t p, const double* numbers) {
      memories[{id(block.sphere(block.wall_pairs.pair[p].own)), kWall}].assign(numbers, numbers + kWidth);
    });
  visit_touching_grain_pairs(
      simulation, [&](const Block& block, std::size_t own, std::size_t p, const double* numbers) {
        const auto ids = std::minmax({id(own), id(block.sphere(block.grain_pairs.pair[p].other))});
        memories[{ids.first, ids.second}].assign(numbers, numbers + kWidth);
      });
  return memories;
}

/// Single spheres of one type or of one each, each pressed onto the one below and the first onto a plane,
/// after a while of sliding and rolling on each other.
Simulation rubbing_column(const ContactLaws& contact, std::size_t count,
                          const std::vector<ParticleType>& types) {
  SimulationSettings settings;
  settings.types = types;
  settings.contact = contact;
  settings.gravity.setZero();
  settings.time_step = kTimeStep;
  WallBodySpec floor;
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  Simulation simulation(settings, {floor});
  std::vector<NewGrain> grains(count);
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const double side = k % 2 == 0 ? 1 : -1;
    grains[k].position.z() = kRadius * (0.99 + 1.99 * static_cast<double>(k));
    grains[k].velocity = {0.1 * side, 0.05 * side, 0};
    grains[k].angular_velocity = side * Eigen::Vector3d(50, 80, 30);
    grains[k].kind = static_cast<TypeNumber>(std::min(k, types.size() - 1));
  }
  simulation.add_grains(grains);
  run_steps(simulation, 20);
  simulation.set_contact(contact);  // searches here: which grain a pair is stored with depends on motion
  return simulation;
}

ParticleType sphere(const std::string& material = kPowderMaterial) {
  return {model_b(kRadius, kMass), material};
}

/// Histories of the contacts of a column of two before and after its law `first` is exchanged for `next`.
struct Exchange {
  Memories before, after;
};
Exchange exchange(const laws::LawParameters& first, const laws::LawParameters& next) {
  Simulation simulation = rubbing_column(one_powder(first, first), 2, {sphere()});
  Exchange exchange{memories_of(simulation), {}};
  simulation.set_contact(one_powder(next, next));
  exchange.after = memories_of(simulation);
  EXPECT_EQ(exchange.before.size(), 2U) << "the column has come apart";
  EXPECT_EQ(exchange.after.size(), exchange.before.size());
  return exchange;
}

/// Expects that the numbers [begin, end) have begun at 0 and that the others are as they were.
void expect_cleared(const Exchange& exchange, std::size_t begin, std::size_t end) {
  for (const auto& [pair, before] : exchange.before) {
    auto expected = before;
    double largest = 0;
    for (std::size_t k = begin; k < end; ++k) {
      largest = std::max(largest, std::abs(before[k]));
      expected[k] = 0;
    }
    EXPECT_GT(largest, 0) << "nothing to clear in " << pair.first << ", " << pair.second;
    EXPECT_EQ(exchange.after.at(pair), expected) << pair.first << ", " << pair.second;
  }
}

TEST(ExchangedLaws, AnotherRollingPartBeginsWithoutTorqueAndTheOthersGoOn) {
  laws::LawParameters next = with_history();
  // Its history is the torque on the other sphere.
  next.rolling = laws::LudingRolling::Parameters{
      .rolling_friction = 0.3, .tangential_stiffness = 50, .time_step = kTimeStep};
  expect_cleared(exchange(with_history(), next), kRollingAt, kRollingAt + 3);
}

TEST(ExchangedLaws, AnotherNormalPartBeginsWithoutMemoryAndTheOthersGoOn) {
  laws::LawParameters next = with_history();
  next.normal = laws::EdinburghNormal::Parameters{.modulus = 1e6};
  expect_cleared(exchange(with_history(), next), 0, kFrictionAt);
}

TEST(ExchangedLaws, AnotherExponentOfTheEdinburghLawBeginsWithoutMemory) {
  laws::LawParameters hertzian = with_history(), linear = with_history();
  hertzian.normal = laws::EdinburghNormal::Parameters{.modulus = 1e6};
  linear.normal =
      laws::EdinburghNormal::Parameters{.branch = laws::EdinburghBranch::linear, .stiffness = 100};
  expect_cleared(exchange(hertzian, linear), 0, kFrictionAt);
}

TEST(ExchangedLaws, OtherParametersOfTheSamePartsKeepAllMemory) {
  laws::LawParameters next = with_history();
  next.normal = laws::LudingNormal::Parameters{.loading = 120, .unloading = 900, .cohesion = 5};
  next.damping = laws::ConstantDamping::Parameters{1e-5};
  next.friction = laws::CundallFriction::Parameters{.tangential = 70, .friction = 0.1};
  next.rolling = laws::Epsd2Rolling::Parameters{.rolling_friction = 0.01, .shear_modulus = 2e6};
  const Exchange kept = exchange(with_history(), next);
  EXPECT_EQ(kept.after, kept.before);
  for (const auto& [pair, numbers] : kept.before) EXPECT_NE(numbers[kFrictionAt], 0);
}

TEST(ExchangedLaws, ContactsOfOtherMaterialsGoOn) {
  const laws::LawParameters law = with_history();
  ContactLaws contact;
  contact.pairs = {{"fine", "fine", law},
                   {"fine", "coarse", law},
                   {"coarse", "coarse", law},
                   {"fine", kWallMaterial, law},
                   {"coarse", kWallMaterial, law}};
  Simulation simulation = rubbing_column(contact, 3, {sphere("fine"), sphere("fine"), sphere("coarse")});
  const Memories before = memories_of(simulation);
  contact.pairs[1].law.friction =
      laws::LudingFriction::Parameters{.static_friction = 0.5, .dynamic_friction = 0.5};
  simulation.set_contact(contact);
  Memories after = memories_of(simulation);
  ASSERT_EQ(before.size(), 3U);
  ASSERT_EQ(after.size(), 3U);
  EXPECT_EQ(after.at({0, kWall}), before.at({0, kWall}));
  EXPECT_EQ(after.at({0, 1}), before.at({0, 1}));
  auto expected = before.at({1, 2});
  EXPECT_NE(expected[kFrictionAt], 0);
  std::fill_n(expected.begin() + kFrictionAt, kRollingAt - kFrictionAt, 0.0);
  EXPECT_EQ(after.at({1, 2}), expected);
}

}  // namespace
}  // namespace diefill::engine
