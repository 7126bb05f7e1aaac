// Fluids for tests, in reduced units: reach, mass and thermal energy are 1.
#pragma once

#include <random>

#include "engine/fluid/fluid_figures.h"

namespace diefill::engine {

/// A cube of this edge, periodic along all axes.
inline FluidSettings cube(double edge, double shear_rate = 0, int threads = 1) {
  FluidSettings settings;
  settings.period = {edge, edge, edge};
  settings.shear_rate = shear_rate;
  settings.threads = threads;
  return settings;
}

struct Particles {
  std::vector<Eigen::Vector3d> places, velocities;
};

/// At random in a box centred on the origin, with thermal velocities on the profile of shear, at rest as a
/// whole.
inline Particles random_fluid(std::size_t count, const Eigen::Vector3d& edges, double shear_rate, int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  std::normal_distribution<double> speed;
  Particles fluid;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const double x = place(random), y = place(random), z = place(random);
    fluid.places.push_back(edges.cwiseProduct(Eigen::Vector3d(x, y, z)));
    const double u = speed(random), v = speed(random), w = speed(random);
    fluid.velocities.emplace_back(u, v, w);
    mean += fluid.velocities.back() / static_cast<double>(count);
  }
  for (std::size_t k = 0; k < count; ++k)
    fluid.velocities[k] += shear_rate * fluid.places[k].y() * Eigen::Vector3d::UnitX() - mean;
  return fluid;
}

/// At the fluid's density.
inline void fill(FluidSimulation& simulation, int seed = 1) {
  const auto& settings = simulation.settings();
  const Eigen::Vector3d edges(*settings.period[0], *settings.period[1], *settings.period[2]);
  const auto count = static_cast<std::size_t>(std::lround(settings.law.density * edges.prod()));
  const Particles fluid = random_fluid(count, edges, settings.shear_rate, seed);
  simulation.add_fluid(fluid.places, fluid.velocities);
}

inline void run(FluidSimulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

/// A ball of particles on a cubic lattice of this spacing.
inline GrainShape ball(double radius, double spacing, double mass_of_particle) {
  std::vector<Eigen::Vector3d> places;
  const int most = static_cast<int>(radius / spacing) + 1;
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z) {
        const Eigen::Vector3d place = spacing * Eigen::Vector3d(x, y, z);
        if (place.norm() <= radius) places.push_back(place);
      }
  const double mass = mass_of_particle * static_cast<double>(places.size());
  return rigid_grain(0.5 * spacing, places, mass, 1);
}

}  // namespace diefill::engine
