// The pair list holds every touching pair, whatever the cloud, its borders and its motion: against all pairs
// by brute force.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "contact_energy.h"
#include "engine_test_support.h"

namespace diefill::engine {
namespace {

/// A pair of spheres named by (grain id, sphere of the grain), the smaller first.
using SphereName = std::pair<std::uint64_t, std::size_t>;
using SpherePairs = std::multiset<std::pair<SphereName, SphereName>>;

std::pair<SphereName, SphereName> named(const Simulation& simulation, std::size_t i, std::size_t j) {
  const std::size_t per_grain = simulation.spheres().spheres_per_grain;
  const auto& ids = simulation.grains().id;
  const SphereName first{ids[i / per_grain], i % per_grain}, second{ids[j / per_grain], j % per_grain};
  return first < second ? std::pair{first, second} : std::pair{second, first};
}

SpherePairs found_pairs(const Simulation& simulation) {
  const auto& field = simulation.spheres();
  SpherePairs pairs;
  visit_touching_grain_pairs(simulation,
                             [&](const Block& block, std::size_t i, std::size_t p, const double*) {
                               std::size_t j = block.sphere(block.grain_pairs.pair[p].other);
                               j = field.owner(j) * field.spheres_per_grain + j % field.spheres_per_grain;
                               pairs.insert(named(simulation, i, j));
                             });
  return pairs;
}

/// Shortest of all periodic images of a distance.
Eigen::Vector3d nearest(const SimulationSettings& settings, Eigen::Vector3d between) {
  for (const std::size_t axis : {0U, 1U})
    if (settings.period[axis]) {
      double& x = between[static_cast<Eigen::Index>(axis)];
      x -= *settings.period[axis] * std::round(x / *settings.period[axis]);
    }
  return between;
}

SpherePairs all_touching_pairs(const Simulation& simulation) {
  const auto& field = simulation.spheres();
  const auto& settings = simulation.settings();
  const std::size_t per_grain = field.spheres_per_grain;
  SpherePairs pairs;
  for (std::size_t a = 0; a < field.grains; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Eigen::Vector3d centres =
          nearest(settings, simulation.grains().position[a] - simulation.grains().position[b]);
      if (centres.norm() > 2 * settings.shape.bounding_radius()) continue;
      for (std::size_t i = a * per_grain; i < (a + 1) * per_grain; ++i)
        for (std::size_t j = b * per_grain; j < (b + 1) * per_grain; ++j)
          if (nearest(settings, eigen(field.position(i) - field.position(j))).norm() <
              2 * settings.shape.sphere_radius)
            pairs.insert(named(simulation, i, j));
    }
  return pairs;
}

struct CloudCase {
  const char* name;
  Model model;
  bool periodic_x, periodic_y;
};

class NeighbourSearch : public ::testing::TestWithParam<CloudCase> {
 protected:
  static constexpr double kWidth = 5e-3;  // m

  /// Soft grains thrown at random into a box, overlapping and flying about.
  static Simulation cloud(std::size_t count) {
    auto settings = weightless(GetParam().model, {.damping_over_radius = 0, .friction = 0.5}, 1e-5);
    settings.grain_contact.reduced_modulus = 1e3;
    settings.grain_contact.tangential = 1e-4;
    if (GetParam().periodic_x) settings.period[0] = kWidth;
    if (GetParam().periodic_y) settings.period[1] = kWidth;
    Simulation simulation(settings, {});
    std::mt19937_64 random(5);
    std::vector<NewGrain> grains(count);
    for (auto& grain : grains) {
      grain.position = random_vector(random, 0.5 * kWidth);
      grain.velocity = random_vector(random, 0.3) + Eigen::Vector3d(0.5, 0.2, 0);
      grain.orientation = random_orientation(random);
      grain.angular_velocity = random_vector(random, 200);
    }
    simulation.add_grains(grains);
    return simulation;
  }
};

TEST_P(NeighbourSearch, TouchingPairsAreThoseOfAllPairs) {
  // Enough for several blocks of spheres.
  const bool single = GetParam().model == Model::a || GetParam().model == Model::b;
  auto simulation = cloud(single ? 2400 : 400);
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
      simulation, [&](const Block& block, std::size_t i, std::size_t p, const double* memory) {
        const std::size_t j = block.sphere(block.grain_pairs.pair[p].other);
        const auto pair = named(simulation, i, j);
        const bool straight = pair.first == SphereName{simulation.grains().id[i / per_grain], i % per_grain};
        found[pair] = straight ? spring_of(memory) : Eigen::Vector3d(-spring_of(memory));
      });
  return found;
}

TEST(ContactMemory, SpringsOfThoseWhoStayOutliveRemovalAndNewSearch) {
  auto settings = weightless(Model::d, {.friction = 1, .work_of_adhesion = 0.15}, 1e-6);
  Simulation simulation(settings, {});
  const double size = 2 * half_size(settings.shape);
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
    simulation.add_grains(converging_cloud({3, 3, 3}, 2 * half_size(settings.shape), 0.3, 8));
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
    const double size = 2 * half_size(settings.shape);
    for (int k = 0; k < 500; ++k)
      grains.push_back({.position = 1.2 * size * Eigen::Vector3d(k % 10, (k / 10) % 10, k / 100)});
    grains[250].velocity = {0, 0, 2};
    simulation.add_grains(grains);
    run_steps(simulation, 2000);
    return simulation.searches();
  };
  const double radius = weightless(Model::d, {}, 1e-6).shape.sphere_radius;
  EXPECT_LT(4 * searches(0), searches(0.1 * radius));
}

}  // namespace
}  // namespace diefill::engine
