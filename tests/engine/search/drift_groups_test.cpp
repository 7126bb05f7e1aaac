// Grains that move together are grouped, and the neighbour list holds every touching pair of groups that
// pass each other, for as long as it lasts.
#include "engine/search/drift_groups.h"

#include <gtest/gtest.h>

#include "engine/search/passing_speed.h"
#include "tests/engine/engine_test_support.h"
#include "tests/engine/touching_pairs.h"

namespace diefill::engine {
namespace {

/// m/s; `share` of 1000 velocities are about `fast`, the others about 0, all scattered by up to `scatter`.
std::vector<Eigen::Vector3d> velocities(double share, const Eigen::Vector3d& fast, double scatter) {
  std::mt19937_64 random(3);
  std::vector<Eigen::Vector3d> all(1000);
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k] = random_vector(random, scatter);
    if (static_cast<double>(k) < share * 1000) all[k] += fast;
  }
  return all;
}

TEST(DriftGroups, AreGrainsThatFallAndGrainsAtRest) {
  const Eigen::Vector3d fall(0.01, 0, -1);
  const auto groups = drift_groups(velocities(0.3, fall, 0.05));
  ASSERT_TRUE(groups);
  const std::size_t falling = groups->group[0];
  for (std::size_t k = 0; k < 1000; ++k) ASSERT_EQ(groups->group[k] == falling, k < 300) << k;
  EXPECT_LT((groups->drift[falling] - fall).norm(), 0.01);
  EXPECT_LT(groups->drift[1 - falling].norm(), 0.01);
  EXPECT_NEAR(passing_speed(groups->drift), 1, 0.01);
}

TEST(DriftGroups, AreNoneInOneMotionWhateverItsScatter) {
  EXPECT_FALSE(drift_groups(velocities(0, {}, 0.5)));
  EXPECT_FALSE(drift_groups(velocities(1, {1, 0, 0}, 0)));
  EXPECT_FALSE(drift_groups({}));
}

TEST(DriftGroups, AreNotMadeForAFewFastGrains) {
  EXPECT_FALSE(drift_groups(velocities(0.03, {0, 0, -1}, 0.05)));
}

struct Passing {
  const char* name;
  Model model;
  bool periodic;
};

class PassingGroups : public ::testing::TestWithParam<Passing> {
 protected:
  static constexpr double kWidth = 6e-3;  // m

  /// A cloud of soft grains, of which the upper half comes down on the lower one and through it, over a
  /// floor.
  static Simulation cloud(double fixed_skin = 0) {
    auto settings = weightless(GetParam().model, {.damping_over_radius = 0, .friction = 0.5}, 5e-6);
    settings.skin = fixed_skin;
    grain_contact(settings)->reduced_modulus = 1e3;
    grain_contact(settings)->tangential = 1e-4;
    if (GetParam().periodic) settings.period[0] = settings.period[1] = kWidth;
    Simulation simulation(settings, {plate(kWidth, 2e-4)});
    std::mt19937_64 random(5);
    std::vector<NewGrain> grains(600);
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const bool upper = k % 2 == 0;
      grains[k].position = random_vector(random, 0.5 * kWidth) + Eigen::Vector3d(0, 0, upper ? 8e-3 : 3.5e-3);
      grains[k].velocity = random_vector(random, 0.01) + Eigen::Vector3d(0, 0, upper ? -1 : 0);
      grains[k].orientation = random_orientation(random);
    }
    simulation.add_grains(grains);
    return simulation;
  }
};

TEST_P(PassingGroups, MissNoTouchWhileAListLasts) {
  auto simulation = cloud();
  std::size_t grouped = 0, seen = 0;
  for (int step = 0; step < 300; ++step) {
    simulation.step();
    const auto expected = all_touching_pairs(simulation);
    ASSERT_EQ(found_pairs(simulation), expected) << "after " << simulation.steps() << " steps";
    seen += expected.size();
    if (simulation.snapshot().reference.groups() == 2) ++grouped;
  }
  EXPECT_GT(seen, 1000U);
  EXPECT_GT(grouped, 200U);
  EXPECT_LT(simulation.searches(), 30U);
}

TEST_P(PassingGroups, MoveAsWithoutGroups) {
  auto grouped = cloud(), plain = cloud(2e-5);
  run_steps(grouped, 1200);
  run_steps(plain, 1200);
  EXPECT_EQ(plain.snapshot().reference.groups(), 1U);
  double farthest = 0;
  for (std::uint64_t id = 0; id < 600; ++id)
    farthest = std::max(farthest,
                        nearest(plain.settings(), position_of(grouped, id) - position_of(plain, id)).norm());
  EXPECT_LT(farthest, 1e-10);
  EXPECT_GT(std::abs(grouped.wall_load(0).force.z()), 0);
}

TEST_P(PassingGroups, GoOnBitForBitAfterARestart) {
  auto unbroken = cloud();
  run_steps(unbroken, 100);
  const Snapshot snapshot = unbroken.snapshot();
  ASSERT_EQ(snapshot.reference.groups(), 2U);
  auto resumed = cloud();
  resumed.restore(snapshot);
  run_steps(unbroken, 200);
  run_steps(resumed, 200);
  EXPECT_EQ(unbroken.hash(), resumed.hash());
}

INSTANTIATE_TEST_SUITE_P(Clouds, PassingGroups,
                         ::testing::Values(Passing{"Spheres", Model::b, false},
                                           Passing{"SpheresPeriodic", Model::b, true},
                                           Passing{"Clumps", Model::d, false},
                                           Passing{"ClumpsPeriodic", Model::d, true}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace diefill::engine
