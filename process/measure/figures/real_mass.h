// What the filled model powder means for the real one: masses in grams, and the fill ratio.
#pragma once

#include <cstdint>

#include "process/results/fill_result.h"

namespace diefill::process {

/// What is known of the real powder.
struct RealPowder {
  double apparent_density = 0;  ///< kg/m^3, as weighed; 0: not known
  double solid_density = 0;     ///< kg/m^3, of the grains' solid
};

/// Model powder that lies outside all cavities, as it stands in the shoe.
struct PowderBed {
  double solid_fraction = 0;  ///< mean over closed cells two diameters deep; NaN where too few count
  std::uint64_t grains = 0;   ///< that count
};

/// Measures the bed; grains of `cavities` do not belong to it. No solid fraction below kMinGrains.
PowderBed powder_bed(const results::FillResult& result, const std::vector<results::CavityState>& cavities);

/// Adds, of the result's cavity: `fill_density_kg_m3` and `cavity_solid_fraction` (all grains in it over its
/// volume); `fill_ratio`, its solid fraction over that of the bed, in which the model's density cancels
/// (Bierwisch 2009, Eq. 4.2); and of the real powder `apparent_density_kg_m3`, `full_die_mass_kg`,
/// `expected_fill_density_kg_m3` and `expected_mass_kg`. Where the powder has not been weighed, the apparent
/// density is estimated as the bed's solid fraction times the solid density, and
/// `apparent_density_is_estimate` is 1. Without a bed there is no fill ratio, only `estimated_mass_kg`: the
/// grains' solid volume times the solid density. What is missing gets its reason (results/no_value.h).
void add_real_mass(results::FillResult& result, const RealPowder& powder, const PowderBed& bed);

}  // namespace diefill::process
