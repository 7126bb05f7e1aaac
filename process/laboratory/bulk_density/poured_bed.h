// Beds of sticky, rolling spheres that are poured onto a plane (Hu 2024, section 5.2).
#pragma once

#include <cstdint>

#include "process/laboratory/bulk_density/bed_figures.h"
#include "process/laboratory/bulk_density/sticky_spheres.h"
#include "process/laboratory/side_by_side.h"

namespace diefill::process::laboratory {

/// A bed of sticky spheres of 0.5 mm, surface energy 0.2 J/m^2. 16.8 g fall from 240 to 330 mm above a plane
/// floor at 0.2 m/s into 21 x 21 mm, periodic, and settle.
struct PouredBed {
  engine::laws::AnyRolling::Parameters rolling = {};
  engine::laws::JkrLoad load = engine::laws::JkrLoad::corrected;
  double scale = 4;          ///< l of the scaled-up particle model
  double pouring_time = 10;  ///< s, until all powder is in
  std::uint64_t seed = 1;
  TellShare tell = [](double) {};
};

struct PouredBedFigures : SphereBedFigures {
  std::uint64_t sphere_steps = 0;
};

/// Pours the bed, lets it settle until spheres hold less than 1e-6 m g d of kinetic energy in the mean, 2 s
/// at most, and measures it.
PouredBedFigures pour_bed(const PouredBed& bed);

}  // namespace diefill::process::laboratory
