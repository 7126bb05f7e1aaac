// The sheared box against all pairs, and the flow in it.
#include <gtest/gtest.h>

#include "tests/engine/fluid/fluid_support.h"

namespace diefill::engine {
namespace {

/// From j to i by the shortest way in a sheared cube, and j's velocity as i sees it.
struct Seen {
  Vector3 separation, velocity;
};
Seen shortest(const FluidSimulation& simulation, std::size_t i, std::size_t j) {
  const Grains& particles = simulation.particles();
  const double edge = *simulation.settings().period[0];
  const double speed = simulation.settings().shear_rate * edge;
  Vector3 between = plain(particles.position[i]) - plain(particles.position[j]);
  const double up = std::round(between.y / edge);
  between.y -= up * edge;
  between.x -= up * speed * simulation.time();
  between.x -= edge * std::round(between.x / edge);
  between.z -= edge * std::round(between.z / edge);
  return {between, plain(particles.velocity[j]) + Vector3{up * speed, 0, 0}};
}

/// Forces on all particles, each pair by itself.
std::vector<Vector3> all_pairs(const FluidSimulation& simulation) {
  const Grains& particles = simulation.particles();
  const auto& law = simulation.policy().law();
  const PairRandom random(simulation.settings().seed, simulation.state().step);
  std::vector<double> density(particles.size());
  const auto for_pairs = [&](const auto& use) {
    for (std::size_t i = 0; i < particles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Seen seen = shortest(simulation, i, j);
        const double distance = length(seen.separation);
        if (distance < law.reach()) use(i, j, seen, distance);
      }
  };
  for_pairs([&](std::size_t i, std::size_t j, const Seen&, double distance) {
    for (const std::size_t k : {i, j}) density[k] += law.density_of(law.weight(distance));
  });
  std::vector<Vector3> force(particles.size());
  for_pairs([&](std::size_t i, std::size_t j, const Seen& seen, double distance) {
    const Vector3 normal = (1 / distance) * seen.separation;
    const double speed = dot(plain(particles.velocity[i]) - seen.velocity, normal);
    const double pushes = law.push(density[i]) + law.push(density[j]);
    const double weight = law.weight(distance), zeta = random.gaussian(particles.id[i], particles.id[j]);
    const Vector3 push =
        (law.between_fluid(weight, pushes, speed) + law.kick_in_fluid(weight, zeta)) * normal;
    force[i] += push;
    force[j] -= push;
  });
  return force;
}

// At times when the images have gone far and by any part of a period.
TEST(ShearedPeriod, ForcesAreThoseOfAllPairs) {
  for (const double time : {0.0, 3.7, 41.3}) {
    FluidSettings settings = cube(6, 0.3);
    settings.time_step = 1e-8;  // so that velocities are those that forces were computed from
    settings.law.noise = 3e-4;
    settings.law.thermal_energy = 1e-8;
    FluidSimulation simulation(settings);
    fill(simulation);
    FluidSnapshot later = simulation.snapshot();
    later.particles.step = later.particles.reference.step =
        static_cast<std::uint64_t>(std::llround(time / settings.time_step));
    later.particles.time = later.particles.reference.time = time;
    simulation.restore(later);
    simulation.step();
    const auto expected = all_pairs(simulation);
    double largest = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      largest = std::max(largest, length(expected[k]));
      EXPECT_LT(length(plain(simulation.particles().force[k]) - expected[k]), 1e-2) << time;
    }
    EXPECT_GT(largest, 10);
  }
}

// Fluid that leaves up comes in from below slower by what parts the two borders.
TEST(ShearedPeriod, WhoLeavesComesBackDisplacedAndSlower) {
  const ShearedPeriod period({6, 4, 5}, 0.5);
  Grains particles;
  particles.resize(1, false, false);
  particles.position[0] = {0.5, 2.1, 2.6};
  particles.velocity[0] = {1, 1, 1};
  period.wrap(particles, 3.25);
  EXPECT_TRUE(particles.position[0].isApprox(Eigen::Vector3d(0, -1.9, -2.4), 1e-12));
  EXPECT_TRUE(particles.velocity[0].isApprox(Eigen::Vector3d(-1, 1, 1), 1e-12));
}

TEST(ShearedPeriod, DrivesFluidAtRestIntoALinearProfile) {
  constexpr double kEdge = 6, kRate = 0.2;
  FluidSimulation simulation(cube(kEdge, kRate));
  const Particles fluid = random_fluid(896, Eigen::Vector3d::Constant(kEdge), 0, 5);
  simulation.add_fluid(fluid.places, fluid.velocities);
  run(simulation, 1000);
  FluidProfile profile{.along = 0, .across = 1, .from = -0.5 * kEdge, .to = 0.5 * kEdge, .layers = 6};
  for (int k = 0; k < 600; ++k) {
    run(simulation, 5);
    profile.add(simulation);
  }
  for (std::size_t layer = 0; layer < profile.layers; ++layer)
    EXPECT_NEAR(profile.velocity(layer), kRate * profile.place(layer), 0.06) << layer;
  double slope = 0, squares = 0;
  for (std::size_t layer = 0; layer < profile.layers; ++layer) {
    slope += profile.velocity(layer) * profile.place(layer);
    squares += profile.place(layer) * profile.place(layer);
  }
  EXPECT_NEAR(slope / squares, kRate, 0.05 * kRate);
}

}  // namespace
}  // namespace diefill::engine
