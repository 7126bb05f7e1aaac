// A bed of spheres that is poured, shaken and discharged, and what its energy balance says after each.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "engine/limits/validity_monitor.h"
#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"
#include "process/powder/material.h"

namespace diefill::support {

/// How much is poured, and for how long it is worked on.
struct BedWork {
  int across = 4, layers = 3;
  double pour = 0.12, shake = 0.05, discharge = 0.05;  ///< s; whole periods of shaking
};

/// Energy gained without work that explains it over the energy exchanged, as engine::ValidityMonitor has it.
struct EnergyGained {
  double poured = 0, shaken = 0, discharged = 0;
  double at_rest = 0;  ///< part of `poured`: in the last third of that time
};

/// Half of a floor of wall spheres of `radius` (m) that repeats with `width` (m) along x and y and reaches
/// beyond the period by as much again: the half with x above zero, or the other one.
inline engine::WallBodySpec half_floor(const std::string& name, double radius, double width, bool above) {
  engine::WallBodySpec body;
  body.name = name;
  body.sphere_radius = radius;
  const int half = static_cast<int>(std::ceil(0.5 * width / (1.6 * radius)));
  const double spacing = 0.5 * width / half;
  for (int i = -2 * half; i < 2 * half; ++i)
    for (int j = -2 * half; j < 2 * half; ++j)
      if (((i + 4 * half) % (2 * half) < half) == above)
        body.centres.push_back({(i + 0.5) * spacing, (j + 0.5) * spacing, -radius});
  return body;
}

/// Spheres on a loose lattice above a floor in two halves, periodic in x and y. Both halves shake up and
/// down and sideways at 40 Hz, up to 1.6 times as hard as gravity pulls; then one of them drops.
inline EnergyGained gained_by(engine::SimulationSettings settings, const BedWork& work) {
  const double radius = settings.shape().sphere_radius, spacing = 2.1 * radius, width = work.across * spacing;
  settings.period = {width, width};
  const double end_of_shaking = work.pour + work.shake;
  const auto shaking = [=](double time) {
    engine::BodyMotion motion;
    if (time < work.pour || time > end_of_shaking) return motion;
    const double rate = 2 * std::numbers::pi * 40, amplitude = 0.1 * radius,
                 phase = rate * (time - work.pour);
    const Eigen::Vector3d way(amplitude, 0, amplitude);
    motion.translation = (1 - std::cos(phase)) * way;
    motion.velocity = rate * std::sin(phase) * way;
    return motion;
  };
  const auto dropping = [=](double time) {
    engine::BodyMotion motion = shaking(time);
    if (time <= end_of_shaking) return motion;
    motion.velocity = {0, 0, -1};
    motion.translation = (time - end_of_shaking) * motion.velocity;
    return motion;
  };
  auto shelf = half_floor("shelf", 0.5 * radius, width, false),
       gate = half_floor("gate", 0.5 * radius, width, true);
  shelf.motion = shaking;
  gate.motion = dropping;
  engine::Simulation simulation(settings, {shelf, gate});
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> shift(-0.05 * radius, 0.05 * radius);
  std::vector<engine::NewGrain> grains(static_cast<std::size_t>(work.across * work.across * work.layers));
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const int n = static_cast<int>(k), across = work.across;
    grains[k].position =
        spacing * Eigen::Vector3d(n % across - 0.5 * across, n / across % across - 0.5 * across,
                                  n / across / across + 0.6) +
        Eigen::Vector3d(shift(random), shift(random), shift(random));
  }
  simulation.add_grains(grains);
  engine::ValidityMonitor monitor;
  const auto until = [&](double time) {
    while (simulation.time() < time) simulation.step();
    monitor.check(simulation);
    return energy_balance_error(simulation);
  };
  EnergyGained gained;
  const double settled = until(2 * work.pour / 3);
  gained.poured = until(work.pour);
  gained.at_rest = gained.poured - settled;
  gained.shaken = until(end_of_shaking);
  gained.discharged = until(end_of_shaking + work.discharge);
  return gained;
}

}  // namespace diefill::support
