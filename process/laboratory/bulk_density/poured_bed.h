// Beds of sticky, rolling spheres that are poured onto a plane (Hu 2024, section 5.2).
#pragma once

#include <cstdint>

#include "engine/laws/law_parameters.h"

namespace diefill::process::laboratory {

/// A bed of mono-disperse spheres: 0.5 mm, 1000 kg/m^3, E = 10 MPa, nu = 0.3, restitution 0.1, friction 0.3,
/// surface energy 0.2 J/m^2, simplified JKR. 16.8 g fall from 240 to 330 mm above a plane floor at 0.2 m/s
/// into 21 x 21 mm, periodic, and settle.
struct PouredBed {
  engine::laws::AnyRolling::Parameters rolling = {};
  engine::laws::JkrLoad load = engine::laws::JkrLoad::corrected;
  double scale = 4;          ///< l of the scaled-up particle model
  double pouring_time = 10;  ///< s, until all powder is in
  std::uint64_t seed = 1;
  int threads = 1;
};

/// Pa, E* and G* between the spheres.
double poured_modulus();
double poured_shear_modulus();

struct PouredBedFigures {
  double density = 0;       ///< kg/m^3, between 20 and 60 mm
  double height = 0;        ///< m, of the highest sphere's top
  double coordination = 0;  ///< mean number of touching spheres of those with centres between 20 and 60 mm
  double simulated = 0;     ///< s
  double kinetic = 0;       ///< mean kinetic energy of a sphere over m g d, at the end
  std::size_t spheres = 0;
  std::uint64_t sphere_steps = 0;
};

/// Pours the bed, lets it settle until spheres hold less than 1e-6 m g d of kinetic energy in the mean, 2 s
/// at most, and measures it.
PouredBedFigures pour_bed(const PouredBed& bed);

}  // namespace diefill::process::laboratory
