// Single contacts and beds are what the built-in engine makes of them, on any number of ranks.
#include "engine/observe/energy_balance.h"
#include "tests/cluster/ranks.h"
#include "tests/engine/mixed_support.h"

namespace diefill::process::cluster {
namespace {

using engine::Model;
using engine::NewGrain;

constexpr double kAlike = 1e-10;

/// Two grains that meet off-centre, spinning.
std::vector<NewGrain> glancing(double apart, double lateral) {
  NewGrain left, right;
  left.position = {-0.5 * apart, 0, 0.5 * lateral};
  left.velocity = {0.1, 0.02, 0};
  left.angular_velocity = {30, 200, -50};
  right.position = -left.position;
  right.velocity = -left.velocity;
  right.angular_velocity = {-20, 100, 70};
  return {left, right};
}

TEST(Contact, OfTwoSpheresIsThatOfTheBuiltInEngine) {
  const auto settings = engine::weightless(
      Model::b, {.friction = 0.5, .work_of_adhesion = 0.005, .rolling_friction = 1e-5}, 2e-6);
  const double size = 2 * engine::half_size(settings.shape());
  Twins twins(settings, {}, glancing(size, 0.4 * size));
  twins.run(200);
  ASSERT_GT(twins.built_in.deepest_overlap_of_run(), 0);
  expect_alike(twins.built_in, twins.on_ranks, size, kAlike);
  EXPECT_NEAR(twins.on_ranks.deepest_overlap_of_run(), twins.built_in.deepest_overlap_of_run(),
              kAlike * twins.built_in.deepest_overlap_of_run());
}

TEST(Collision, OfTwoClumpsIsThatOfTheBuiltInEngine) {
  for (const Model model : {Model::c, Model::d}) {
    const auto settings = engine::weightless(model, {.friction = 0.5, .work_of_adhesion = 0.005}, 2e-6);
    const double size = 2 * engine::half_size(settings.shape());
    Twins twins(settings, {}, glancing(size, 0.2 * size));
    twins.run(600);
    ASSERT_GT(twins.built_in.deepest_overlap_of_run(), 0);
    expect_alike(twins.built_in, twins.on_ranks, size, kAlike);
    EXPECT_NEAR(twins.on_ranks.ledger().viscous_work, twins.built_in.ledger().viscous_work,
                kAlike * std::abs(twins.built_in.ledger().viscous_work));
  }
}

/// A plate that shakes along x.
engine::BodyMotion shaking(double time) {
  engine::BodyMotion motion;
  motion.translation.x() = 1e-4 * std::sin(2000 * time);
  motion.velocity.x() = 0.2 * std::cos(2000 * time);
  return motion;
}

/// A shaking groove along y of triangles, 12 `size` wide, its bottom 1.6 `size` below the origin.
engine::WallBodySpec groove(double size) {
  engine::WallBodySpec groove;
  groove.name = "groove";
  groove.motion = shaking;
  constexpr int kStrips = 12;
  const auto corner = [&](int x, int y) {
    return Eigen::Vector3d((x - kStrips / 2) * size, (y - kStrips / 2) * size,
                           (0.1 * std::abs(x - kStrips / 2) - 1.6) * size);
  };
  for (int x = 0; x < kStrips; ++x)
    for (int y = 0; y < kStrips; ++y) {
      groove.triangles.push_back({{corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)}});
      groove.triangles.push_back({{corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)}});
    }
  return groove;
}

engine::WallBodySpec shaking_plate(double size) {
  engine::WallBodySpec floor = engine::plate(4 * size, 1.5e-4, shaking);
  for (auto& centre : floor.centres) centre.z() -= 1.6 * size;
  return floor;
}

/// Grains of a model thrown together and down onto a shaking floor, in a periodic slice.
Twins bed(Model model, engine::WallBodySpec (*floor_of)(double size) = shaking_plate) {
  auto settings = engine::weightless(model, {.friction = 0.5, .work_of_adhesion = 0.01}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 2e-5;
  const double size = 2 * engine::half_size(settings.shape());
  settings.period = {6 * size, 6 * size};
  auto cloud = engine::converging_cloud({5, 5, 3}, size, 0.3, 21);
  for (auto& grain : cloud) grain.velocity.z() -= 0.4;
  return {settings, {floor_of(size)}, cloud};
}

TEST(Bed, OfEveryModelMovesAsInTheBuiltInEngineUntilRoundingGrows) {
  for (const Model model : {Model::a, Model::b, Model::c, Model::d}) {
    Twins twins = bed(model);
    const double size = 2 * engine::half_size(twins.built_in.settings().shape());
    twins.run(500);
    ASSERT_GT(twins.built_in.touching_pairs(), 10U);
    expect_alike(twins.built_in, twins.on_ranks, size, 1e-8);
    EXPECT_EQ(twins.on_ranks.touching_pairs(), twins.built_in.touching_pairs());
    const engine::Ledger &ledger = twins.on_ranks.ledger(), &expected = twins.built_in.ledger();
    EXPECT_GT(std::abs(expected.wall_work), 0);
    EXPECT_NEAR(ledger.wall_work, expected.wall_work, 1e-8 * std::abs(expected.wall_work));
    EXPECT_NEAR(ledger.viscous_work, expected.viscous_work, 1e-8 * std::abs(expected.viscous_work));
    EXPECT_NEAR(ledger.tangential_work, expected.tangential_work, 1e-8 * std::abs(expected.tangential_work));
    EXPECT_NEAR(engine::energy_balance_error(twins.on_ranks), engine::energy_balance_error(twins.built_in),
                1e-8);
  }
}

TEST(Bed, InAGrooveOfTrianglesMovesAsInTheBuiltInEngine) {
  for (const Model model : {Model::b, Model::d}) {
    Twins twins = bed(model, groove);
    const double size = 2 * engine::half_size(twins.built_in.settings().shape());
    twins.run(500);
    ASSERT_GT(std::abs(twins.built_in.ledger().wall_work), 0);
    expect_alike(twins.built_in, twins.on_ranks, size, 1e-8);
    EXPECT_NEAR(twins.on_ranks.ledger().wall_work, twins.built_in.ledger().wall_work,
                1e-8 * std::abs(twins.built_in.ledger().wall_work));
  }
}

TEST(Bed, GoesOnFromWhatWasShownAsIfItHadNotStopped) {
  for (const auto floor : {shaking_plate, groove}) {
    Twins twins = bed(Model::d, floor);
    const double size = 2 * engine::half_size(twins.built_in.settings().shape());
    run_on_ranks(twins.on_ranks, 300);
    engine_on_ranks().forget();  // reloads, springs and all
    run_on_ranks(twins.on_ranks, 100);
    engine::run_steps(twins.on_ranks, 100);  // either engine goes on from the other
    engine::run_steps(twins.built_in, 500);
    expect_alike(twins.built_in, twins.on_ranks, size, 1e-8);
  }
}

/// Grains of several sizes and two materials that fall on a steel floor.
Twins mixed_bed(const engine::GrainMix& mix, const engine::WallBodySpec& floor) {
  using namespace engine;
  auto settings = settings_of(mix, 2e-6);
  settings.gravity = {0, 0, -9.81};
  auto cloud = converging_cloud({4, 4, 3}, 4.2 * kMixRadius, 0.3, 5);
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    cloud[k].kind = static_cast<TypeNumber>(k % mix.kinds.size());
    cloud[k].orientation = {1, 0, 0, 0};
  }
  return {settings, {floor}, cloud};
}

TEST(Bed, OfSeveralSizesAndComposedLawsMovesAsInTheBuiltInEngine) {
  using namespace engine;
  const auto mix =
      mix_of({1, 1.5, 2}, laws::bierwisch_law({1e6, 20, 100, 0.4, 0.01, 1e-5}),
             laws::bierwisch_law({2e6, 30, 100, 0.2, 0, 0}), laws::bierwisch_law({1e6, 20, 100, 0.15, 0, 0}));
  Twins twins = mixed_bed(mix, steel_floor(-8 * kMixRadius));
  twins.run(1500);
  ASSERT_GT(twins.built_in.touching_pairs(), 3U);
  expect_alike(twins.built_in, twins.on_ranks, kMixRadius, 1e-8);
}

/// Hertz and Mindlin with a restitution of 0.5.
engine::laws::LawParameters mindlin_law(double modulus, double friction) {
  using namespace engine::laws;
  LawParameters law{.normal = HertzMindlinNormal::Parameters{modulus}};
  law.damping = RestitutionDamping::Parameters{0.5, modulus};
  law.friction = MindlinFriction::Parameters{.shear_modulus = 0.2 * modulus, .friction = friction};
  return law;
}

TEST(Bed, OfMindlinsSpheresInASteelGrooveOfTrianglesMovesAsInTheBuiltInEngine) {
  using namespace engine;
  const auto mix = mix_of({1, 1.5, 2}, mindlin_law(1e6, 0.3), mindlin_law(2e6, 0.4), mindlin_law(2e6, 0.2));
  WallBodySpec floor = groove(4 * kMixRadius);
  floor.material = "steel";
  Twins twins = mixed_bed(mix, floor);
  twins.run(1500);
  ASSERT_GT(std::abs(twins.built_in.ledger().wall_work), 0);
  expect_alike(twins.built_in, twins.on_ranks, kMixRadius, 1e-8);
}

TEST(Mirror, ActsOnGrainsAsInTheBuiltInEngine) {
  const auto settings = engine::weightless(Model::d, {.friction = 0.5}, 2e-6);
  const double size = 2 * engine::half_size(settings.shape());
  engine::WallBodySpec mirror;
  mirror.name = "mirror plane";
  mirror.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  mirror.mirror = true;
  NewGrain grain;
  grain.position = {0.55 * size, 0, 0};
  grain.velocity = {-0.2, 0.03, 0};
  grain.angular_velocity = {10, 40, -90};
  Twins twins(settings, {mirror}, {grain});
  twins.run(600);
  ASSERT_GT(twins.built_in.deepest_overlap_of_run(), 0);
  expect_alike(twins.built_in, twins.on_ranks, size, kAlike);
}

TEST(Powder, ThatLeavesAndComesIsFollowed) {
  Twins twins = bed(Model::d);
  const double size = 2 * engine::half_size(twins.built_in.settings().shape());
  twins.run(200);
  for (auto* simulation : {&twins.built_in, &twins.on_ranks}) {
    simulation->remove_grains([](const Eigen::Vector3d& place) { return place.x() > 5e-4; });
    NewGrain extra;
    extra.position = {0, 0, 5e-3};
    extra.velocity = {0, 0, -1};
    simulation->add_grains({extra});
    simulation->set_gravity({0, 0, -5});
  }
  twins.run(200);
  expect_alike(twins.built_in, twins.on_ranks, size, 1e-8);
}

TEST(Simulation, WithoutGrainsStepsOnRanks) {
  const auto settings = engine::weightless(Model::d, {}, 2e-6);
  Twins twins(settings, {engine::plate(1e-3, 1.5e-4, shaking)}, {});
  twins.run(30);
  EXPECT_EQ(twins.on_ranks.steps(), 30U);
  EXPECT_EQ(twins.on_ranks.body_motion(0).translation, twins.built_in.body_motion(0).translation);
}

}  // namespace
}  // namespace diefill::process::cluster
