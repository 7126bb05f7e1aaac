// What is measured of a bed of spheres at rest on a floor: density and contacts between two heights.
#pragma once

#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

struct BedWindow {
  double low = 0.020, high = 0.060;  ///< m above the floor
};

struct SphereBedFigures {
  double density = 0;       ///< kg/m^3 of powder in the window, with the parts of spheres that reach into it
  double height = 0;        ///< m, of the highest sphere's top
  double coordination = 0;  ///< mean number of touching spheres of those with centres in the window
  double simulated = 0;     ///< s
  double kinetic = 0;       ///< mean kinetic energy of a sphere over m g d, as of kinetic_per_sphere()
  std::size_t spheres = 0;
};

/// Mean kinetic energy of the spheres over m g d of the sphere of mean mass.
double kinetic_per_sphere(const engine::Simulation& simulation);

/// Figures of single spheres, periodic along x and y with the floor at z = 0.
SphereBedFigures figures_of_bed(const engine::Simulation& simulation, const BedWindow& window = {});

}  // namespace diefill::process::laboratory
