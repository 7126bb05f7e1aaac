#include "process/laboratory/published/sawing/viscosity.h"

#include <array>
#include <cmath>

#include "engine/fluid/fluid_figures.h"

namespace diefill::process::laboratory::sawing {
namespace {

/// Mean, and standard deviation of it.
struct Estimate {
  double mean = 0, deviation = 0;
};

Estimate estimate(const std::array<double, 10>& parts) {
  constexpr double kParts = 10;
  double sum = 0, squares = 0;
  for (const double part : parts) sum += part, squares += part * part;
  const double mean = sum / kParts;
  return {mean, std::sqrt(std::max(0.0, squares / kParts - mean * mean) / (kParts - 1))};
}

}  // namespace

ShearedFigures measure(const ShearedSlurry& slurry, std::uint64_t seed) {
  engine::FluidSettings settings;
  settings.period = {slurry.edge, slurry.edge, slurry.edge};
  settings.shear_rate = slurry.rate;
  settings.time_step = slurry.time_step;
  settings.seed = seed;
  settings.threads = all_threads();
  engine::FluidSimulation simulation(settings);
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * slurry.edge);
  const SlurrySpace space{-half, half, settings.period, slurry.edge * slurry.edge * slurry.edge,
                          [](const Eigen::Vector3d&) { return 1e9; }};
  ShearedFigures figures;
  figures.solids = fill(space, {.solids = slurry.solids, .density = slurry.density}, seed, simulation).solids;
  figures.particles = static_cast<double>(simulation.particles().size());
  for (int k = 0; k < slurry.settling; ++k) simulation.step();
  std::array<double, 10> viscosity{};
  const int part_steps = slurry.sampled / 10;
  for (double& part : viscosity)
    for (int k = 0; k < part_steps; ++k) {
      simulation.step();
      const Eigen::Matrix3d pressure = engine::fluid_pressure(simulation);
      const double share = 1.0 / part_steps;
      if (slurry.rate != 0) part -= 0.5 * share * (pressure(0, 1) + pressure(1, 0)) / slurry.rate;
      figures.pressure += 0.1 * share * pressure.trace() / 3;
      figures.temperature += 0.1 * share * engine::fluid_temperature(simulation);
    }
  const Estimate all = estimate(viscosity);
  figures.viscosity = all.mean;
  figures.scatter = all.deviation;
  return figures;
}

}  // namespace diefill::process::laboratory::sawing
