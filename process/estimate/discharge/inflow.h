// The mass that runs into openings while a shoe passes over them.
#pragma once

#include "process/estimate/discharge/powder_discharge.h"
#include "process/estimate/openings/exposure.h"

namespace diefill::process::estimate {

/// What the inflow follows from besides the openings and the shoe. SI units.
struct InflowPowder {
  PowderDischarge law;
  double density = 0;         ///< kg/m^3, apparent
  double grain_diameter = 0;  ///< m, of the grains in question
  double gravity = continuum::kStandardGravity;
};

/// m, what is left of an opening of `width` for these grains: width - 1.4 (d - d of the law), none below zero
/// (Bierwisch 2009, section 3.2.2).
double effective_width(double width, const InflowPowder& powder);

/// The powder that comes over one place in one exposure, portion by portion: fresh powder comes each time
/// that the shoe has advanced by the opening's length along its path. All that asks for how long powder has
/// time to fall goes by this.
struct Portions {
  double width = 0;     ///< m, of the slit that lets them through, effective; 0: too narrow for these grains
  double share = 0;     ///< of the place's area that lets powder through
  double count = 1;     ///< at least 1
  double seconds = 0;   ///< s that each of them is over the place while the shoe moves
  double standing = 0;  ///< s more of the last, over which the shoe stands; no speed of the shoe changes it
  double longest() const { return seconds + standing; }
};

/// Those of a place, of which no more than the shoe's length is covered at a time. The shoe goes `faster`
/// times as fast as the scene has it.
Portions portions_of(const OpeningPatch& place, const Exposure& exposure, const ShoePath& path,
                     const InflowPowder& powder, double faster = 1);

/// kg that run into each opening in each crossing, by opening and crossing, as if it had no floor.
///
/// A generalisation of Eq. 5.17 (Bierwisch 2009) from a slit to openings of any shape (ours): every place
/// lets through what a slit of its local width does, on an area reduced by the empty annulus.
std::vector<std::vector<double>> inflow(const OpeningLayout& layout, const ShoePath& path,
                                        const InflowPowder& powder);

/// kg that run into opening `opening` in its first crossings, by crossing, with the shoe `faster` times as
/// fast as the scene has it.
std::vector<double> inflow_at(const OpeningLayout& layout, const ShoePath& path, const InflowPowder& powder,
                              std::size_t opening, std::size_t crossings, double faster);

}  // namespace diefill::process::estimate
