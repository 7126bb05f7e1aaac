// Powders of several kinds: what must not change, whatever the number of threads, restarts or the order in
// which grains were added; what is refused; and a powder of one kind given as a mix.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "engine/coarse_graining/methods.h"
#include "engine/limits/pinched_grains.h"
#include "engine/limits/validity_monitor.h"
#include "engine/observe/contact_forces.h"
#include "engine/observe/contact_stress.h"
#include "engine/observe/energy_balance.h"
#include "engine/observe/powder_figures.h"
#include "tests/engine/mixed_support.h"

namespace diefill::engine {
namespace {

laws::LawParameters rough() {
  return bierwisch_parts({.reduced_modulus = 1e7,
                          .damping = 150,
                          .tangential = 150,
                          .friction = 0.5,
                          .work_of_adhesion = 0.002});
}

/// The same, with a `damping` (Pa s) by which the smallest of kTenfold are not overdamped.
laws::LawParameters lightly_damped(double damping = 10) {
  return bierwisch_parts({1e7, damping, 50, 0.5, 2e-4});  // E~, gamma_n, kappa_t, mu, w
}

/// Sizes over a range of ten.
const std::vector<double> kTenfold = {1, 0.1, 0.4, 0.17};

struct Bed {
  bool periodic = true;
  int threads = 1;
  InstructionSet instructions = best_instruction_set();
  double air = 2e-5;  // Pa s
};

Simulation empty_bed(const Bed& bed, const laws::LawParameters& law = lightly_damped()) {
  auto settings = settings_of(mix_of(kTenfold, law, law, law), 4e-7);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = bed.air;
  settings.threads = bed.threads;
  settings.instructions = bed.instructions;
  if (bed.periodic) settings.period = {14 * kMixRadius, 14 * kMixRadius};
  return {settings, {steel_floor()}};
}

/// A few large spheres among many small ones, all in a box above the floor, none touching another at first.
std::vector<NewGrain> crowd(std::size_t wanted, std::uint64_t seed) {
  const PeriodicBox box({14 * kMixRadius, 14 * kMixRadius});
  std::mt19937_64 random(seed);
  std::vector<NewGrain> grains;
  std::vector<double> radii;
  while (grains.size() < wanted) {
    NewGrain grain;
    const std::size_t number = grains.size();
    grain.kind = number < wanted / 40 ? 0 : number < wanted / 8 ? 2 : number < wanted / 2 ? 3 : 1;
    const double radius = kMixRadius * kTenfold[grain.kind];
    grain.position = random_vector(random, 6.5 * kMixRadius);
    grain.position.z() = radius + 0.45 * std::abs(grain.position.z());
    bool free = true;
    for (std::size_t k = 0; k < number && free; ++k)
      free = box.wrapped(grains[k].position - grain.position).norm() > radius + radii[k];
    if (!free) continue;
    grain.velocity = random_vector(random, 0.1) - Eigen::Vector3d(0, 0, 0.4);
    grain.angular_velocity = random_vector(random, 100);
    grains.push_back(grain);
    radii.push_back(radius);
  }
  return grains;
}

/// Pairs of ids of spheres that overlap, of all pairs there are.
std::set<std::pair<std::uint64_t, std::uint64_t>> overlapping(const Simulation& simulation) {
  const Grains& grains = simulation.grains();
  const PeriodicBox box(simulation.settings().period);
  std::set<std::pair<std::uint64_t, std::uint64_t>> pairs;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = simulation.shape_of(i).sphere_radius + simulation.shape_of(j).sphere_radius;
      if (box.wrapped(grains.position[i] - grains.position[j]).norm() < reach)
        pairs.insert(std::minmax(grains.id[i], grains.id[j]));
    }
  return pairs;
}

std::set<std::pair<std::uint64_t, std::uint64_t>> found(const Simulation& simulation) {
  const Grains& grains = simulation.grains();
  const SphereField& spheres = simulation.spheres();
  std::set<std::pair<std::uint64_t, std::uint64_t>> pairs;
  for (const Block& block : simulation.neighbours().blocks())
    for (std::size_t p = 0; p < block.grain_pairs.size(); ++p) {
      if (!block.grain_pairs.touching[p]) continue;
      const GrainPair pair = block.grain_pairs.pair[p];
      pairs.insert(std::minmax(grains.id[spheres.owner(block.sphere(pair.own))],
                               grains.id[spheres.owner(block.sphere(pair.other))]));
    }
  return pairs;
}

class MixedBed : public ::testing::TestWithParam<bool> {
 protected:
  Bed bed() const { return {.periodic = GetParam()}; }
};

TEST_P(MixedBed, TouchingPairsAreThoseOfAllPairs) {
  auto simulation = empty_bed(bed());
  simulation.add_grains(crowd(1500, 7));
  std::size_t seen = 0;
  for (int round = 0; round < 12; ++round) {
    run_steps(simulation, 60);
    const auto expected = overlapping(simulation);
    ASSERT_EQ(found(simulation), expected) << "after " << simulation.steps() << " steps";
    seen += expected.size();
  }
  EXPECT_GT(seen, 200U);
  EXPECT_GT(simulation.searches(), 5U);
  EXPECT_GT(simulation.neighbours().blocks().size(), 1U);
}

TEST_P(MixedBed, ThreadsRestartAndInstructionsChangeNoBit) {
  auto alone = empty_bed(bed());
  const auto grains = crowd(1500, 8);
  alone.add_grains(grains);
  run_steps(alone, 700);
  Bed other = bed();
  other.threads = 2;
  other.instructions = InstructionSet::baseline;
  auto broken = empty_bed(other);
  broken.add_grains(grains);
  run_steps(broken, 300);
  ASSERT_FALSE(broken.snapshot().grain_history.pair.empty());
  auto resumed = empty_bed(other);
  resumed.restore(broken.snapshot());
  EXPECT_EQ(resumed.hash(), broken.hash());
  run_steps(resumed, 400);
  EXPECT_EQ(resumed.hash(), alone.hash());
  EXPECT_EQ(energy_of(resumed).total(), energy_of(alone).total());
  EXPECT_LT(alone.wall_load(0).force.z(), 0);
}

TEST_P(MixedBed, OrderInWhichGrainsAreAddedChangesNoBit) {
  const auto grains = crowd(800, 9);
  std::vector<std::size_t> order(grains.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = (k * 373 + 11) % order.size();
  std::vector<NewGrain> permuted;
  for (const std::size_t k : order) permuted.push_back(grains[k]);
  auto one = empty_bed(bed()), other = empty_bed(bed());
  one.add_grains(grains);
  other.add_grains(permuted);
  run_steps(one, 500);
  run_steps(other, 500);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t here = place_of(one, order[k]), there = place_of(other, k);
    ASSERT_EQ(one.grains().position[here], other.grains().position[there]) << k;
    ASSERT_EQ(one.grains().spin[here], other.grains().spin[there]) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(OpenAndPeriodic, MixedBed, ::testing::Bool());

TEST(MixedCloud, KeepsMomentumAndAngularMomentumAndBooksItsEnergy) {
  auto law = rough();
  law.rolling = laws::LoadRolling::Parameters{.rolling_friction = 0.05};
  for (const auto model : {Model::b, Model::d}) {
    auto mix = mix_of({1, 0.5, 0.8}, law, rough(), rough());
    if (model == Model::d)
      for (auto& kind : mix.kinds) kind.shape = model_d(kind.shape.sphere_radius / 3, kind.shape.mass);
    Simulation simulation(settings_of(mix, 5e-8), {});
    simulation.add_grains(mixed_cloud({4, 4, 4}, 2.05 * kMixRadius, 0.5, 3, 4));
    const Eigen::Vector3d before = momentum_of_mix(simulation);
    const Eigen::Vector3d turning = angular_momentum_of_mix(simulation);
    ASSERT_GT(most_touching(simulation, 10000), 10U);
    double scale = 0;
    for (std::size_t k = 0; k < simulation.grains().size(); ++k)
      scale += simulation.shape_of(k).mass * simulation.grains().velocity[k].norm();
    EXPECT_LT((momentum_of_mix(simulation) - before).norm(), 1e-12 * scale);
    // Single spheres: forces act at full radii, as far apart as the overlap; clumped grains meet in a point.
    const double lost = (angular_momentum_of_mix(simulation) - turning).norm() / (scale * kMixRadius);
    EXPECT_LT(lost, model == Model::d ? 1e-12 : 0.05);
    EXPECT_NEAR(energy_balance_error(simulation), 0, 2e-3);
    EXPECT_NE(simulation.ledger().rolling_work, 0);
  }
}

TEST(MixedCloud, ForcesOfContactsSumUpToThoseOnGrains) {
  // Undamped: forces do not depend on velocities, which have changed since.
  auto simulation = empty_bed({.air = 0}, lightly_damped(0));
  simulation.add_grains(crowd(600, 3));
  run_steps(simulation, 600);
  const Grains& grains = simulation.grains();
  std::vector<Eigen::Vector3d> sum(grains.size(), Eigen::Vector3d::Zero());
  double largest = 0;
  visit_contact_forces(simulation, [&](const ContactForce& contact) {
    sum[contact.grain] += contact.force;
    EXPECT_LE(contact.arm.norm(), simulation.shape_of(contact.grain).sphere_radius);
    largest = std::max(largest, contact.force.norm());
    if (contact.other == kNoGrain) return;
    sum[contact.other] -= contact.force;
    EXPECT_LE(contact.other_arm.norm(), simulation.shape_of(contact.other).sphere_radius);
  });
  ASSERT_GT(largest, 0);
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const Eigen::Vector3d weight = simulation.shape_of(k).mass * simulation.settings().gravity;
    EXPECT_LT((sum[k] + weight - grains.force[k]).norm(), 1e-12 * largest) << k;
  }
}

TEST(MixedSleep, SettledGrainsOfAllSizesSleepAndARestartChangesNoBit) {
  const auto dry =
      bierwisch_parts({.reduced_modulus = 1e7, .damping = 30, .tangential = 50, .friction = 0.5});
  auto mix = mix_of({1, 0.25, 0.5}, dry, dry, dry);
  for (auto& kind : mix.kinds) kind.shape = model_a(kind.shape.sphere_radius, kind.shape.mass);
  constexpr double kFlat = std::numeric_limits<double>::infinity();
  auto settings = settings_of(mix, 0.2 * critical_time_step(mix, {{"steel", kFlat}}, 0.3));
  settings.gravity = {0, 0, -9.81};
  settings.period = {10 * kMixRadius, 10 * kMixRadius};
  settings.sleep = SleepSettings{};
  Simulation simulation(settings, {steel_floor()});
  auto grains = mixed_cloud({4, 4, 4}, 2.2 * kMixRadius, 0.02, 3, 12);
  for (auto& grain : grains) grain.position.z() += 5 * kMixRadius;
  simulation.add_grains(grains);
  for (int round = 0; round < 60 && sleepers(simulation) < 40; ++round) run_steps(simulation, 2000);
  ASSERT_GE(sleepers(simulation), 40U);
  std::set<TypeNumber> kinds;
  for (std::size_t k = 0; k < simulation.grains().size(); ++k)
    if (asleep(simulation, k)) kinds.insert(simulation.grains().kind[k]);
  EXPECT_EQ(kinds.size(), 3U);
  Simulation resumed(settings, {steel_floor()});
  resumed.restore(simulation.snapshot());
  run_steps(simulation, 500);
  run_steps(resumed, 500);
  EXPECT_EQ(resumed.hash(), simulation.hash());
}

TEST(MixOfOneKind, GivenTwiceMovesAlike) {
  // Two kinds that are the same: through the tables, and through the loop that looks nothing up.
  auto one_kind = mix_of({1}, rough(), rough(), rough());
  auto two_kinds = one_kind;
  two_kinds.kinds.push_back(one_kind.kinds.front());
  Simulation one(settings_of(one_kind, 2e-7), {steel_floor(-5 * kMixRadius)});
  Simulation other(settings_of(two_kinds, 2e-7), {steel_floor(-5 * kMixRadius)});
  auto cloud = mixed_cloud({4, 4, 4}, 2 * kMixRadius, 0.4, 2, 8);
  other.add_grains(cloud);
  for (auto& grain : cloud) grain.kind = 0;
  one.add_grains(cloud);
  EXPECT_GT(most_touching(one, 2000), 10U);
  run_steps(other, 2000);
  for (std::uint64_t id = 0; id < cloud.size(); ++id)
    EXPECT_LT((position_of(one, id) - position_of(other, id)).norm(), 1e-9 * kMixRadius);
}

TEST(MixedValidityMonitor, OverlapCountsOverTheSmallerSphere) {
  // An overlap of 0.07 of a large sphere is 0.7 of a small one.
  auto settings = settings_of(mix_of({1, 0.1}, rough(), rough(), rough()), 1e-9);
  for (const TypeNumber kind : {TypeNumber{0}, TypeNumber{1}}) {
    Simulation simulation(settings, {});
    std::vector<NewGrain> grains(2);
    grains[1].kind = kind;
    const double reach = kMixRadius * (kind == 0 ? 2 : 1.1);
    grains[1].position.x() = reach - 0.07 * kMixRadius;
    simulation.add_grains(grains);
    simulation.step();
    EXPECT_NEAR(simulation.overlaps().grains, 0.07 * kMixRadius, 1e-4 * kMixRadius);
    EXPECT_NEAR(simulation.overlaps().grains_over_radius, kind == 0 ? 0.07 : 0.7, 1e-3);
    if (kind == 0)
      EXPECT_NO_THROW(ValidityMonitor().check(simulation));
    else
      EXPECT_THROW(ValidityMonitor().check(simulation), OutOfRange);
  }
}

/// What is wrong with a mix, or with the settings and walls around it.
std::string refusal(const SimulationSettings& settings, const WallBodySpec& wall) {
  try {
    Simulation simulation(settings, {wall});
    simulation.add_grains({NewGrain{.kind = 7}});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

TEST(MixRefusals, NameWhatIsWrong) {
  const auto good = settings_of(mix_of({1, 0.5}, rough(), rough(), rough()), 1e-7);
  EXPECT_NE(refusal(good, steel_floor()).find("type 7, but there are 2"), std::string::npos);

  auto bad = good;
  bad.types[1].shape.sphere_offsets.clear();
  EXPECT_NE(refusal(bad, steel_floor()).find("particle type 1 has no spheres"), std::string::npos);
  bad = good;
  bad.contact.pairs.erase(bad.contact.pairs.begin() + 2);
  EXPECT_NE(refusal(bad, steel_floor()).find("'iron' and 'wax'"), std::string::npos);
  bad = good;
  bad.types.assign(300, good.types.front());
  EXPECT_NE(refusal(bad, steel_floor()).find("at most 256"), std::string::npos);
  bad = good;
  bad.types.clear();
  EXPECT_NE(refusal(bad, steel_floor()).find("at least one particle type"), std::string::npos);
  bad = good;
  bad.contact.pairs[1].law.attraction = laws::VanDerWaals::Parameters{.hamaker = 5e-18};
  EXPECT_NE(refusal(bad, steel_floor()).find("between 'wax' and 'wax': van der Waals"), std::string::npos);

  auto wall = steel_floor();
  wall.material = "brass";
  EXPECT_NE(refusal(good, wall).find("'iron' and 'brass'"), std::string::npos);
}

}  // namespace
}  // namespace diefill::engine
