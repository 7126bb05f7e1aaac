// The mass that runs into openings while a shoe passes over them.
#pragma once

#include "process/estimate/exposure.h"
#include "process/estimate/powder_discharge.h"

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

/// kg that run into each opening in each crossing, by opening and crossing, as if it had no floor. The shoe
/// goes `faster` times as fast as the scene has it.
///
/// A generalisation of Eq. 5.17 (Bierwisch 2009) from a slit to openings of any shape (ours): every place
/// lets through what a slit of its local width does, on an area reduced by the empty annulus; fresh powder
/// comes over it each time that the shoe has advanced by the opening's length along its path.
std::vector<std::vector<double>> inflow(const OpeningLayout& layout, const ShoePath& path,
                                        const InflowPowder& powder, double faster = 1);

}  // namespace diefill::process::estimate
