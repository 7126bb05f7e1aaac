// A bed of adhesive powder that is packed, pressed in five cycles between 0.5 and 15 kPa and pulled apart
// (Kottlan 2018, sections 2.7.2 and 2.7.3): its run and what is read off its results.
#pragma once

#include <limits>
#include <string>

#include "process/laboratory/published/lactose/adhesive_bed.h"
#include "process/laboratory/published/lactose/load_cycles.h"

namespace diefill::process::laboratory {

/// A run of adhesive_bed.toml.
struct PressedBed {
  std::string name;  ///< of the run
  AdhesivePowder powder;
  AdhesiveBed bed;

  double area() const;  ///< m^2
};

LabRun run_of(const PressedBed& bed);

/// Coarse: 6 d wide, 10 d of powder; medium: 8 d and 15 d; published: 16 d and 20 d.
AdhesiveBed pressed_bed_of(LabSize size);

/// Heights of the plate and stresses on it, from 50 Pa on: the height there is the bed's initial one.
LoadCurve load_curve(const SeedResults& seed, const PressedBed& bed);
/// Of the plate while it is pulled off.
PullCurve pull_curve(const SeedResults& seed, const PressedBed& bed);

/// Results of one bed; NaN where there is none.
struct BedMetrics {
  double initial_fraction, final_fraction;  ///< of the middle six tenths, before and after the cycles
  Stiffness stiffness;
  double strength;  ///< Pa, tensile
  double fracture;  ///< d, see Tension
};

/// The bed of a run of adhesive_bed.toml as it is packed, before anything presses it; in the end the scene
/// clears it away.
const results::PowderState& packed_bed(const SeedResults& seed, const std::string& run);

BedMetrics metrics_of(const SeedResults& seed, const PressedBed& bed);

/// Of the middle six tenths of a bed.
double middle_fraction(const results::PowderState& powder);

}  // namespace diefill::process::laboratory
