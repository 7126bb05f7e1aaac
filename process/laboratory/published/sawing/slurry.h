// The slurry of a wire saw as particles: irregular grains of silicon carbide in a fluid (Bierwisch 2009,
// appendix A). In reduced units, in which reach, mass and thermal energy of a fluid particle are 1.
#pragma once

#include <functional>
#include <random>

#include "engine/fluid/fluid_simulation.h"

namespace diefill::process::laboratory::sawing {

/// What numbers in reduced units stand for, as published (section A.2; OP-16).
struct ReducedUnits {
  static constexpr double viscosity = 0.050;                      ///< mPa s
  static constexpr double velocity = 183;                         ///< m/s
  static constexpr double pressure = 8.3;                         ///< N/mm^2
  static constexpr double micrometres = 5;                        ///< of the process: 1 um is 0.2 r_c
  static constexpr double velocity_of_process = 183 * 17. / 131;  ///< m/s: 131 m/s stand for 17 (OP-17)
  static constexpr double pressure_of_process = 8.3 * 1.5 / 89;   ///< N/mm^2: 89 stand for 1.5 (Table A.1)
};

/// r_c, between particles of a solid.
inline constexpr double kSpacing = 0.6;
/// Over the density of the fluid: 1.7 g/cm^3 of slurry with 25 vol% of 3.21 g/cm^3.
inline constexpr double kGrainDensity = 2.68;

/// Mass of a solid's particle, which stands for a cell of the lattice, of this density over the fluid's.
double particle_mass(double density_over_fluid);

/// A grain of the volume of a sphere of diameter `size` (r_c): a ball of particles on a lattice that planes
/// have cut.
engine::GrainShape irregular_grain(double size, std::mt19937_64& random);

/// The space that a slurry fills.
struct SlurrySpace {
  Eigen::Vector3d lower, upper;  ///< r_c, a box around it
  engine::PeriodLengths period;
  double volume = 0;  ///< r_c^3
  /// r_c, of a point from the nearest wall; below 0: not in the space.
  std::function<double(const Eigen::Vector3d&)> clearance;
  /// The fluid's mean velocity at a point to begin with; nothing: that of the simulation's shear.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> flow = {};
};

/// Share of solids, and sizes (r_c) with equal shares of it.
struct SlurryMixture {
  double solids = 0;
  double density = 4.15;  ///< of the fluid between them
  std::vector<double> sizes = {1.2, 2, 2.8, 4};
};

/// What has been filled in.
struct FilledSlurry {
  std::size_t first_grain = 0;     ///< number among the simulation's solids
  std::vector<double> grain_size;  ///< r_c, of each grain
  double solids = 0;               ///< share that found room
};

/// Fills grains at random into the space, the largest first, and fluid between them.
FilledSlurry fill(const SlurrySpace& space, const SlurryMixture& mixture, std::uint64_t seed,
                  engine::FluidSimulation& simulation);

}  // namespace diefill::process::laboratory::sawing
