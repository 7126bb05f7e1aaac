#include "engine/fluid/fluid_figures.h"

#include <stdexcept>

namespace diefill::engine {

namespace {

/// m/s, against the profile of a sheared box.
Eigen::Vector3d own_motion(const FluidSimulation& simulation, const Eigen::Vector3d& place,
                           const Eigen::Vector3d& velocity) {
  return velocity - simulation.settings().shear_rate * place.y() * Eigen::Vector3d::UnitX();
}

}  // namespace

double fluid_temperature(const FluidSimulation& simulation) {
  const Grains& particles = simulation.particles();
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (!simulation.is_fluid(k)) continue;
    sum += own_motion(simulation, particles.position[k], particles.velocity[k]).squaredNorm();
    ++count;
  }
  return simulation.settings().particle_mass * sum / (3 * count);
}

Eigen::Matrix3d fluid_pressure(const FluidSimulation& simulation) {
  double volume = 1;
  for (const auto& period : simulation.settings().period) {
    if (!period)
      throw std::invalid_argument("the pressure tensor needs a box that is periodic along x, y and z");
    volume *= *period;
  }
  const Grains& particles = simulation.particles();
  const RigidSets& solids = simulation.solids();
  Eigen::Matrix3d sum = simulation.policy().virial();
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (!simulation.is_fluid(k)) continue;
    const Eigen::Vector3d motion = own_motion(simulation, particles.position[k], particles.velocity[k]);
    sum += simulation.settings().particle_mass * motion * motion.transpose();
  }
  for (std::size_t s = 0; s < solids.size(); ++s) {
    const Eigen::Vector3d motion =
        own_motion(simulation, solids.motion()[s].centre, solids.motion()[s].velocity);
    sum += solids.spec(s).shape.mass * motion * motion.transpose();
  }
  return sum / volume;
}

std::vector<Eigen::Matrix3d> solid_pressure_times_volume(const FluidSimulation& simulation) {
  const Grains& particles = simulation.particles();
  std::vector<Eigen::Matrix3d> sums(simulation.solids().size(), Eigen::Matrix3d::Zero());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (simulation.is_fluid(k)) continue;
    const std::uint64_t id = particles.id[k];
    sums[simulation.solids().set_of(id)] -= particles.force[k] * simulation.solids().arm(id).transpose();
  }
  return sums;
}

void FluidProfile::add(const FluidSimulation& simulation) {
  velocity_sum.resize(layers);
  count.resize(layers);
  const Grains& particles = simulation.particles();
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (!simulation.is_fluid(k)) continue;
    const double layer = (particles.position[k][across] - from) / (to - from) * static_cast<double>(layers);
    if (layer < 0 || layer >= static_cast<double>(layers)) continue;
    velocity_sum[static_cast<std::size_t>(layer)] += particles.velocity[k][along];
    count[static_cast<std::size_t>(layer)] += 1;
  }
}

double FluidProfile::place(std::size_t layer) const {
  return from + (to - from) * (static_cast<double>(layer) + 0.5) / static_cast<double>(layers);
}

double FluidProfile::velocity(std::size_t layer) const {
  return velocity_sum[layer] / count[layer];
}

}  // namespace diefill::engine
