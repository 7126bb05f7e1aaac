// The pair list holds every touching pair, whatever the cloud, its borders and its motion: against all pairs
// by brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/engine/engine_test_support.h"
#include "tests/engine/touching_pairs.h"

namespace diefill::engine {
namespace {

struct CloudCase {
  const char* name;
  Model model;
  bool periodic_x, periodic_y;
};

class NeighbourSearch : public ::testing::TestWithParam<CloudCase> {
 protected:
  static constexpr double kWidth = 5e-3;  // m

  static bool single_spheres() { return GetParam().model == Model::a || GetParam().model == Model::b; }

  /// Soft grains thrown at random into a box, overlapping and flying about, `pace` times as fast as usual.
  static Simulation cloud(std::size_t count, double pace = 1) {
    auto settings = weightless(GetParam().model, {.damping_over_radius = 0, .friction = 0.5}, 1e-5);
    grain_contact(settings)->reduced_modulus = 1e3;
    grain_contact(settings)->tangential = 1e-4;
    if (GetParam().periodic_x) settings.period[0] = kWidth;
    if (GetParam().periodic_y) settings.period[1] = kWidth;
    Simulation simulation(settings, {});
    std::mt19937_64 random(5);
    std::vector<NewGrain> grains(count);
    for (auto& grain : grains) {
      grain.position = random_vector(random, 0.5 * kWidth);
      grain.velocity = pace * (random_vector(random, 0.3) + Eigen::Vector3d(0.5, 0.2, 0));
      grain.orientation = random_orientation(random);
      grain.angular_velocity = pace * random_vector(random, 200);
    }
    simulation.add_grains(grains);
    return simulation;
  }
};

TEST_P(NeighbourSearch, TouchingPairsAreThoseOfAllPairs) {
  // Enough for several blocks of spheres.
  auto simulation = cloud(single_spheres() ? 2400 : 400);
  std::size_t seen = 0;
  for (int round = 0; round < 20; ++round) {
    run_steps(simulation, 15);
    const auto expected = all_touching_pairs(simulation);
    ASSERT_EQ(found_pairs(simulation), expected) << "after " << simulation.steps() << " steps";
    ASSERT_EQ(simulation.touching_pairs(), expected.size());
    seen += expected.size();
  }
  EXPECT_GT(seen, 1000U);
  EXPECT_GT(simulation.searches(), 5U);
  EXPECT_GT(simulation.neighbours().blocks().size(), 1U);
}

TEST_P(NeighbourSearch, NoTouchIsMissedInAnyStepWhileAListLasts) {
  // So slow that lists last for many steps: they must hold whatever comes to touch.
  auto simulation = cloud(single_spheres() ? 900 : 300, 0.02);
  run_steps(simulation, 2);
  std::size_t begun = 0;
  SpherePairs before = found_pairs(simulation);
  for (int step = 0; step < 400; ++step) {
    simulation.step();
    const auto expected = all_touching_pairs(simulation);
    ASSERT_EQ(found_pairs(simulation), expected) << "after " << simulation.steps() << " steps";
    begun += static_cast<std::size_t>(std::count_if(
        expected.begin(), expected.end(), [&](const auto& pair) { return before.count(pair) == 0; }));
    before = expected;
  }
  EXPECT_GT(begun, 20U);
  EXPECT_LT(simulation.searches(), 100U);
}

TEST_P(NeighbourSearch, SurvivesRemovalAndAdditionOnTheWay) {
  auto simulation = cloud(300);
  for (int round = 0; round < 10; ++round) {
    run_steps(simulation, 20);
    const double edge = 0.4 * kWidth - 1e-4 * round;
    simulation.remove_grains([&](const Eigen::Vector3d& place) { return place.z() > edge; });
    NewGrain extra;
    extra.position = {0.5 * kWidth, -0.3 * kWidth, -0.5 * kWidth + 1e-4 * round};
    simulation.add_grains({extra});
    simulation.step();
    ASSERT_EQ(found_pairs(simulation), all_touching_pairs(simulation));
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds, NeighbourSearch,
                         ::testing::Values(CloudCase{"SpheresOpen", Model::b, false, false},
                                           CloudCase{"SpheresPeriodicX", Model::a, true, false},
                                           CloudCase{"DOpen", Model::d, false, false},
                                           CloudCase{"DPeriodicX", Model::d, true, false},
                                           CloudCase{"DPeriodicY", Model::d, false, true},
                                           CloudCase{"DPeriodicBoth", Model::d, true, true},
                                           CloudCase{"CPeriodicBoth", Model::c, true, true}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// Springs of touching pairs by name, of the first-named sphere against the other.
std::map<std::pair<SphereName, SphereName>, Eigen::Vector3d> springs(const Simulation& simulation) {
  std::map<std::pair<SphereName, SphereName>, Eigen::Vector3d> found;
  const std::size_t per_grain = simulation.spheres().spheres_per_grain;
  visit_touching_grain_pairs(
      simulation, [&](const Block& block, std::size_t i, std::size_t p, const double* history) {
        const std::size_t j = block.sphere(block.grain_pairs.pair[p].other);
        const auto pair = named(simulation, i, j);
        const bool straight = pair.first == SphereName{simulation.grains().id[i / per_grain], i % per_grain};
        found[pair] = straight ? spring_of(history) : Eigen::Vector3d(-spring_of(history));
      });
  return found;
}

TEST(ContactMemory, SpringsOfThoseWhoStayOutliveRemovalAndNewSearch) {
  auto settings = weightless(Model::d, {.friction = 1, .work_of_adhesion = 0.15}, 1e-6);
  Simulation simulation(settings, {});
  const double size = 2 * half_size(settings.shape());
  simulation.add_grains(converging_cloud({4, 4, 4}, size, 0.3, 8));
  run_steps(simulation, 800);
  const auto before = springs(simulation);
  ASSERT_GT(before.size(), 20U);
  simulation.remove_grains([](const Eigen::Vector3d& place) { return place.y() > 0.3 * 4.7e-4; });
  const auto after = springs(simulation);
  ASSERT_GT(after.size(), 10U);
  ASSERT_LT(after.size(), before.size());
  double longest = 0;
  for (const auto& [pair, spring] : after) {
    ASSERT_TRUE(before.count(pair));
    EXPECT_EQ(spring, before.at(pair));
    longest = std::max(longest, spring.norm());
  }
  EXPECT_GT(longest, 0);
}

TEST(ContactMemory, ShorterSkinMeansMoreSearchesAndTheSameMotion) {
  const auto run = [](double skin) {
    auto settings = weightless(Model::d, {.friction = 0.5}, 1e-6);
    settings.skin = skin;
    Simulation simulation(settings, {});
    simulation.add_grains(converging_cloud({3, 3, 3}, 2 * half_size(settings.shape()), 0.3, 8));
    run_steps(simulation, 400);
    return std::pair{simulation.searches(), position_of(simulation, 13)};
  };
  const auto [many, place] = run(2e-6);
  const auto [few, same_place] = run(1e-4);
  EXPECT_GT(many, 4 * few);
  EXPECT_LT((place - same_place).norm(), 1e-15);
}

TEST(AdaptiveSkin, GivesSwiftGrainsMoreWayAndNeverMoreThanThereIsRoom) {
  const double radius = 1e-4, skin = 0.1 * radius;
  const AdaptiveSkin free(0, radius), narrow(0, radius, 0.5 * radius), fixed(1e-5, radius);
  EXPECT_EQ(free.doublings(skin, 0), 0);
  // A list of this skin should last 400 steps: 0.4 radii and a quarter to spare ask for 0.05 x 2^4 radii.
  EXPECT_EQ(free.doublings(skin, 1e-3 * radius), 4);
  EXPECT_EQ(free.doublings(skin, 1), 5);
  EXPECT_EQ(narrow.doublings(skin, 1), 3);
  EXPECT_EQ(fixed.doublings(1e-5, 1), 0);
}

TEST(AdaptiveSkin, AFewSwiftGrainsDoNotWearOutTheListOfAll) {
  const auto searches = [](double fixed_skin) {
    auto settings = weightless(Model::d, {}, 1e-6);
    settings.skin = fixed_skin;
    Simulation simulation(settings, {});
    std::vector<NewGrain> grains;
    const double size = 2 * half_size(settings.shape());
    for (int k = 0; k < 500; ++k)
      grains.push_back({.position = 1.2 * size * Eigen::Vector3d(k % 10, (k / 10) % 10, k / 100)});
    grains[250].velocity = {0, 0, 2};
    simulation.add_grains(grains);
    run_steps(simulation, 2000);
    return simulation.searches();
  };
  const double radius = weightless(Model::d, {}, 1e-6).shape().sphere_radius;
  EXPECT_LT(4 * searches(0), searches(0.1 * radius));
}

}  // namespace
}  // namespace diefill::engine
