// What is measured of a bed of spheres between two heights, from its results: solid fraction, contacts,
// sizes.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

/// m^3 of spheres between two heights (m), with the parts of spheres that reach into it.
double volume_between(const results::PowderState& powder, double from, double to);

/// Share of spheres in the volume between two heights (m) of a bed with periods along x and y, with the parts
/// of spheres that reach into it.
double fraction_between(const results::PowderState& powder, double from, double to);

/// Mean number of touching spheres of those whose centres lie between two heights (m), images beyond periods
/// among them; NaN without any.
double contacts_between(const results::PowderState& powder, double from, double to);

/// Share of the smallest kind in the mass of each of `slices` equal slices between two heights (m), by
/// centres; NaN where a slice is empty.
std::vector<double> small_share_by_slice(const results::PowderState& powder, double from, double to,
                                         int slices);

/// m, top of the highest sphere; 0 without any.
double top_of(const results::PowderState& powder);

/// Mean kinetic energy of a grain without its spin over m g d of the grain of mean mass.
double kinetic_energy_over_weight(const results::PowderState& powder);

}  // namespace diefill::process::laboratory
