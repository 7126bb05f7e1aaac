// Viscosity of fluid and slurry in a sheared box (Bierwisch 2009, section A.2.3). Reduced units.
#pragma once

#include <string>

#include "process/laboratory/published/custom_run.h"
#include "process/laboratory/published/sawing/slurry.h"

namespace diefill::process::laboratory::sawing {

/// A cube of slurry under shear.
struct ShearedSlurry {
  double edge = 10;
  double rate = 0.1;
  double solids = 0;      ///< share of the volume
  double density = 4.15;  ///< of the fluid; its law asks for 4.15
  double grip = 1;        ///< DpdParameters::grip
  double time_step = 0.01;
  int settling = 1000, sampled = 6000;  ///< steps
};

struct ShearedFigures {
  double viscosity = 0, temperature = 0, pressure = 0;
  double scatter = 0;  ///< of the viscosity, standard deviation of the mean of ten equal times
  double solids = 0;   ///< share of the volume that found room
  double particles = 0;
};

/// One line: all that the figures depend on, but the seed.
std::string settings_text(const ShearedSlurry& slurry);
/// Particle steps, about.
double work_of(const ShearedSlurry& slurry);

/// Throws CustomRunStopped.
ShearedFigures measure(const ShearedSlurry& slurry, std::uint64_t seed, CustomRunWatch& watch);
/// The same, unwatched.
ShearedFigures measure(const ShearedSlurry& slurry, std::uint64_t seed);

}  // namespace diefill::process::laboratory::sawing
