// Temperature and pressure of a fluid of particles, as of the last step.
#pragma once

#include "engine/fluid/fluid_simulation.h"

namespace diefill::engine {

/// J, k_B T' of the fluid's motion beside the profile of a sheared box: m |v|^2 / 3, mean over its particles.
double fluid_temperature(const FluidSimulation& simulation);

/// Pa, pressure tensor of a box with periods along all axes: momentum that steady forces and motion carry,
/// solids as wholes; compression is positive. Random forces carry none in the mean and are left out. The
/// viscosity of a sheared box is -P_xy over the rate. Throws std::invalid_argument where an axis has no
/// period.
Eigen::Matrix3d fluid_pressure(const FluidSimulation& simulation);

/// J, pressure tensor within each solid times its volume, from the forces on its particles; compression is
/// positive.
std::vector<Eigen::Matrix3d> solid_pressure_times_volume(const FluidSimulation& simulation);

/// m/s, velocity of the fluid along an axis in layers of equal thickness across another one.
struct FluidProfile {
  Eigen::Index along = 0, across = 1;
  double from = 0, to = 0;  ///< m, along `across`
  std::size_t layers = 0;
  std::vector<double> velocity_sum = {}, count = {};  ///< m/s and particles, of all samples

  /// Adds the fluid as it is now.
  void add(const FluidSimulation& simulation);
  double place(std::size_t layer) const;     ///< m, its middle
  double velocity(std::size_t layer) const;  ///< m/s, mean of all samples
};

}  // namespace diefill::engine
