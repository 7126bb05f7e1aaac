// Beds of sticky spheres of log-normal sizes that fall together onto a plane (Hu 2024, section 6.3).
#pragma once

#include <cstdint>

#include "process/laboratory/bulk_density/bed_figures.h"
#include "process/laboratory/side_by_side.h"

namespace diefill::process::laboratory {

/// Diameters of 1 mm in the mean, by number, times `scale`. A source's bed measures 56 mm times `scale` each
/// way; this one may be smaller, with as much powder on each square metre: 0.18 kg on 56 mm x 56 mm. All
/// spheres hang between 25 and 1015 mm above the floor, move at 0.2 m/s downward, fall and settle without
/// rolling resistance.
struct LogNormalBed {
  double variation = 0;         ///< standard deviation of the diameter over its mean, before the cut-offs
  double surface_energy = 0.2;  ///< J/m^2
  double scale = 4;             ///< l of the scaled-up particle model
  double share_of_width = 1;    ///< of the source's, at most 1
  std::uint64_t seed = 1;
  TellShare tell = [](double) {};
};

struct LogNormalBedFigures : SphereBedFigures {
  double smallest = 0, largest = 0;  ///< m, diameters as simulated
  std::uint64_t sphere_steps = 0;
};

/// Lets the bed fall and settle, 1.5 s at most (the fall takes 0.45 s of them), and measures it. Sizes are
/// kept from the 1st to the 99.9th percentile by number [assumed: the source does not say] and cut into
/// classes.
LogNormalBedFigures settle_log_normal_bed(const LogNormalBed& bed);

}  // namespace diefill::process::laboratory
