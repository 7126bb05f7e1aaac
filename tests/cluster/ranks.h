// What the tests of runs on ranks share: the engine, and its steps beside those of the built-in one.
#pragma once

#include <gtest/gtest.h>

#include "process/cluster/lammps/lammps_engine.h"
#include "tests/engine/engine_test_support.h"

namespace diefill::process::cluster {

/// Of this program, on rank 0, where the tests run.
LammpsEngine& engine_on_ranks();

/// Steps `simulation` on the ranks, looking at it every `every` steps and at the end.
inline void run_on_ranks(engine::Simulation& simulation, std::uint64_t steps, std::uint64_t every = 20) {
  LammpsEngine& ranks = engine_on_ranks();
  const std::uint64_t end = simulation.steps() + steps;
  while (simulation.steps() < end)
    ranks.step(simulation, std::min(end, (simulation.steps() / every + 1) * every));
  ranks.sync_contacts(simulation);
}

/// Two simulations of the same settings, walls and grains, for either engine.
struct Twins {
  engine::Simulation built_in, on_ranks;

  Twins(const engine::SimulationSettings& settings, const std::vector<engine::WallBodySpec>& walls,
        const std::vector<engine::NewGrain>& grains)
      : built_in(settings, walls), on_ranks(settings, walls) {
    engine_on_ranks().forget();
    built_in.add_grains(grains);
    on_ranks.add_grains(grains);
  }
  void run(std::uint64_t steps) {
    engine::run_steps(built_in, static_cast<int>(steps));
    run_on_ranks(on_ranks, steps);
  }
};

/// Expects all grains of two simulations to move alike: positions over `length` (m), velocities and spins
/// over the largest, within `tolerance`.
inline void expect_alike(const engine::Simulation& one, const engine::Simulation& other, double length,
                         double tolerance) {
  ASSERT_EQ(one.grains().size(), other.grains().size());
  EXPECT_EQ(one.steps(), other.steps());
  double fastest = 0, swiftest = 0, place = 0, velocity = 0, spin = 0;
  for (std::size_t k = 0; k < one.grains().size(); ++k) {
    const std::size_t n = engine::place_of(other, one.grains().id[k]);
    fastest = std::max(fastest, one.grains().velocity[k].norm());
    swiftest = std::max(swiftest, one.grains().spin[k].norm());
    place = std::max(place, (one.grains().position[k] - other.grains().position[n]).norm());
    velocity = std::max(velocity, (one.grains().velocity[k] - other.grains().velocity[n]).norm());
    spin = std::max(spin, (one.grains().spin[k] - other.grains().spin[n]).norm());
  }
  EXPECT_GT(fastest, 0);
  EXPECT_LE(place, tolerance * length);
  EXPECT_LE(velocity, tolerance * fastest);
  EXPECT_LE(spin, tolerance * swiftest);
}

}  // namespace diefill::process::cluster
