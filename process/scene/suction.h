// Air drawn through the powder by a tool that goes down: the table [suction].
#pragma once

#include <string>

namespace diefill::process {

/// What the resistance of the powder to air follows from. SI units.
struct SuctionSpec {
  std::string tool;              ///< the one whose motion draws the air
  double particle_diameter = 0;  ///< m, of the real powder
  double viscosity = 1.8e-5;     ///< Pa s, of the air
  double solid_fraction = 0;     ///< of the powder in the way; 0: as loosely as the model packs
};

}  // namespace diefill::process
