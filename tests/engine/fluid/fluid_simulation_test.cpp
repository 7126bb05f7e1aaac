// A fluid of particles as a whole: temperature, energy, momentum, the same bits whoever computes it.
#include <gtest/gtest.h>

#include "tests/engine/fluid/fluid_support.h"

namespace diefill::engine {
namespace {

Eigen::Vector3d momentum(const FluidSimulation& simulation) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < simulation.particles().size(); ++k)
    if (simulation.is_fluid(k))
      sum += simulation.settings().particle_mass * simulation.particles().velocity[k];
  for (std::size_t s = 0; s < simulation.solids().size(); ++s)
    sum += simulation.solids().spec(s).shape.mass * simulation.solids().motion()[s].velocity;
  return sum;
}

// Random forces heat, damping cools; both balance at the temperature that their ratio asks for.
TEST(FluidSimulation, TemperatureIsThatOfFluctuationAndDissipation) {
  for (const double thermal_energy : {1.0, 0.5}) {
    FluidSettings settings = cube(6);
    settings.time_step = 0.0025;  // longer ones lower the temperature
    settings.law.thermal_energy = thermal_energy;
    FluidSimulation simulation(settings);
    fill(simulation);
    run(simulation, 1000);
    double sum = 0;
    constexpr int kSamples = 200;
    for (int k = 0; k < kSamples; ++k) {
      run(simulation, 15);
      sum += fluid_temperature(simulation) / kSamples;
    }
    EXPECT_NEAR(sum, thermal_energy, 0.02 * thermal_energy);
  }
}

TEST(FluidSimulation, MomentumIsConserved) {
  FluidSimulation simulation(cube(6));
  fill(simulation);
  RigidSetSpec solid;
  solid.shape = ball(1, 0.6, 1);
  simulation.add_solid(solid);
  run(simulation, 200);
  EXPECT_LT(momentum(simulation).norm(), 1e-9);
  EXPECT_GT(simulation.solids().motion()[0].velocity.norm(), 1e-3);
}

/// Largest change of the energy of a fluid without noise in time 0.5.
double energy_error(const Particles& start, double edge, double time_step) {
  FluidSettings settings = cube(edge);
  settings.law.noise = 0;
  settings.time_step = time_step;
  FluidSimulation simulation(settings);
  simulation.add_fluid(start.places, start.velocities);
  const auto energy = [&] {
    double sum = 1.5 * fluid_temperature(simulation) * static_cast<double>(start.places.size());
    for (const double density : simulation.policy().densities())
      sum += simulation.policy().law().energy(density);
    return sum;
  };
  simulation.step();
  const double first = energy();
  double most = 0;
  for (int k = 0; k < std::lround(0.5 / time_step); ++k) {
    simulation.step();
    most = std::max(most, std::abs(energy() - first));
  }
  return most;
}

TEST(FluidSimulation, EnergyWithoutNoiseConvergesWithTheSquareOfTheStep) {
  constexpr double kEdge = 5;
  FluidSimulation warm(cube(kEdge));
  fill(warm);
  run(warm, 500);
  const Particles start{warm.particles().position, warm.particles().velocity};
  const double coarse = energy_error(start, kEdge, 0.004), fine = energy_error(start, kEdge, 0.001);
  EXPECT_GT(std::log2(coarse / fine) / 2, 1.7) << coarse << ' ' << fine;
  EXPECT_LT(fine, 0.01 * static_cast<double>(start.places.size()));
}

/// Two solids in a sheared fluid of several blocks.
FluidSimulation slurry(int threads) {
  FluidSimulation simulation(cube(9, 0.2, threads));
  fill(simulation, 3);
  RigidSetSpec solid;
  solid.shape = ball(1.3, 0.6, 1);
  simulation.add_solid(solid);
  solid.centre = {0, 4.2, 1};
  simulation.add_solid(solid);
  return simulation;
}

TEST(FluidSimulation, HasTheSameBitsOnOneAndTwoThreads) {
  FluidSimulation one = slurry(1), two = slurry(2);
  EXPECT_GT(one.state().list.blocks().size(), 2U);
  run(one, 120), run(two, 120);
  EXPECT_GT(one.state().searches, 5U);
  EXPECT_EQ(one.hash(), two.hash());
  EXPECT_EQ(fluid_pressure(one), fluid_pressure(two));
}

TEST(FluidSimulation, GoesOnFromASnapshotBitForBit) {
  FluidSimulation straight = slurry(1), interrupted = slurry(1);
  run(straight, 143);
  run(interrupted, 67);
  const FluidSnapshot snapshot = interrupted.snapshot();
  FluidSimulation again = slurry(2);
  run(again, 5);
  again.restore(snapshot);
  EXPECT_EQ(again.hash(), interrupted.hash());
  run(again, 76);
  EXPECT_EQ(again.hash(), straight.hash());
}

TEST(FluidSimulation, DependsOnTheSeedOfItsRandomForces) {
  std::vector<std::uint64_t> hashes;
  for (const std::uint64_t seed : {1, 2}) {
    FluidSettings settings = cube(5);
    settings.seed = seed;
    FluidSimulation simulation(settings);
    fill(simulation);
    run(simulation, 3);
    hashes.push_back(simulation.hash());
  }
  EXPECT_NE(hashes[0], hashes[1]);
}

TEST(FluidSimulation, RefusesWhatCannotWork) {
  const auto make = [](auto change) {
    FluidSettings settings = cube(6);
    change(settings);
    return FluidSimulation(settings);
  };
  EXPECT_THROW(make([](auto& settings) { settings.time_step = 0; }), std::invalid_argument);
  EXPECT_THROW(make([](auto& settings) { settings.particle_mass = 0; }), std::invalid_argument);
  EXPECT_THROW(make([](auto& settings) { settings.period[0] = 1.5; }), std::invalid_argument);
  EXPECT_THROW(make([](auto& settings) {
                 settings.shear_rate = 0.1;
                 settings.period[1].reset();
               }),
               std::invalid_argument);
  FluidSimulation simulation(cube(6));
  EXPECT_THROW(simulation.add_fluid({Eigen::Vector3d::Zero()}, {}), std::invalid_argument);
  EXPECT_THROW(simulation.add_solid({}), std::invalid_argument);
  EXPECT_THROW(simulation.restore(slurry(1).snapshot()), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine
