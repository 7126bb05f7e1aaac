// Air drawn through the powder by a tool that moves down: the table [suction].
#pragma once

#include <string>

namespace diefill::process {

/// What the powder's resistance to air follows from. SI units.
struct SuctionSpec {
  std::string tool;              ///< the one whose motion draws the air
  double particle_diameter = 0;  ///< m, of the real powder
  double viscosity = 1.8e-5;     ///< Pa s, of the air
  double solid_fraction = 0;     ///< of the powder in the way; 0: as loosely as the model packs
};

}  // namespace diefill::process
