// A shoe that passes over a pocket leaves as much powder in it on ranks as with the built-in engine.
#include <cmath>

#include "tests/cluster/ranks.h"

namespace diefill::process::cluster {
namespace {

constexpr double kWall = 1.5e-4, kSpacing = 1.6 * kWall;     // m, wall spheres
constexpr double kPocket = 1.5e-3, kDepth = 1e-3;            // m, half width; depth
constexpr double kStart = 4e-3, kSpeed = 0.4, kWait = 5e-3;  // m, m/s, s

/// Wall spheres on a grid over [from, to], both corners of a face that is level or upright.
void cover(std::vector<Eigen::Vector3d>& centres, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
           bool pocket_left_out = false) {
  const Eigen::Vector3i count = ((to - from) / kSpacing).array().round().cast<int>();
  for (int z = 0; z <= count.z(); ++z)
    for (int y = 0; y <= count.y(); ++y)
      for (int x = 0; x <= count.x(); ++x) {
        const Eigen::Vector3d place = from + kSpacing * Eigen::Vector3d(x, y, z);
        const bool in_pocket = std::abs(place.x()) < kPocket && std::abs(place.y()) < kPocket;
        if (!pocket_left_out || !in_pocket) centres.push_back(place);
      }
}

engine::WallBodySpec die() {
  engine::WallBodySpec body;
  body.name = "die";
  body.sphere_radius = kWall;
  cover(body.centres, {-7e-3, -2.4e-3, -kWall}, {7e-3, 2.4e-3, -kWall}, true);
  cover(body.centres, {-kPocket, -kPocket, -kDepth - kWall}, {kPocket, kPocket, -kDepth - kWall});
  for (const double side : {-kPocket - kWall, kPocket + kWall}) {
    cover(body.centres, {side, -kPocket, -kDepth}, {side, kPocket, -kWall});
    cover(body.centres, {-kPocket, side, -kDepth}, {kPocket, side, -kWall});
  }
  return body;
}

engine::WallBodySpec shoe() {
  engine::WallBodySpec body;
  body.name = "shoe";
  body.sphere_radius = kWall;
  const double half = 1.9e-3, low = kWall + 2e-5, high = 5e-3;
  for (const double side : {-half, half}) {
    cover(body.centres, {side, -half, low}, {side, half, high});
    cover(body.centres, {-half, side, low}, {half, side, high});
  }
  body.motion = [](double time) {
    engine::BodyMotion motion;
    const bool moves = time > kWait && time < kWait + 2 * kStart / kSpeed;
    motion.translation.x() = kStart - kSpeed * std::clamp(time - kWait, 0.0, 2 * kStart / kSpeed);
    motion.velocity.x() = moves ? -kSpeed : 0;
    return motion;
  };
  return body;
}

engine::Simulation filling(std::uint64_t seed) {
  auto settings = engine::weightless(engine::Model::b, {.friction = 0.4}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  engine::Simulation simulation(settings, {die(), shoe()});
  auto cloud = engine::converging_cloud({8, 8, 10}, 3.9e-4, 0, seed, {kStart, 0, 2.2e-3});
  for (auto& grain : cloud) {
    grain.velocity = {0, 0, -0.2};
    grain.angular_velocity.setZero();
  }
  simulation.add_grains(cloud);
  return simulation;
}

int in_pocket(const engine::Simulation& simulation) {
  int count = 0;
  for (const auto& place : simulation.grains().position) count += place.z() < 0;
  return count;
}

TEST(Passage, FillsThePocketAsTheBuiltInEngineDoes) {
  constexpr int kSteps = 14000;
  double sum = 0, squares = 0, on_ranks = 0;
  constexpr int kSeeds = 3;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    auto built_in = filling(seed), other = filling(seed);
    engine::run_steps(built_in, kSteps);
    engine_on_ranks().forget();
    run_on_ranks(other, kSteps, 100);
    const double count = in_pocket(built_in);
    sum += count;
    squares += count * count;
    on_ranks += in_pocket(other);
    std::printf("seed %d: %d grains in the pocket, on ranks %d\n", static_cast<int>(seed),
                in_pocket(built_in), in_pocket(other));
  }
  const double mean = sum / kSeeds, scatter = std::sqrt((squares - sum * mean) / (kSeeds - 1));
  ASSERT_GT(mean, 100);
  // Means of three scatter by 0.6 of one; two of those, twice.
  EXPECT_NEAR(on_ranks / kSeeds, mean, 2 * std::sqrt(2.0 / kSeeds) * std::max(scatter, 1.0));
}

}  // namespace
}  // namespace diefill::process::cluster
