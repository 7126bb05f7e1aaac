// Measures a filled die: solid fraction per grain, Gaussian-averaged fields, filled mass, fill level.
// Works on results alone, so that every figure can be made again later without simulating.
#pragma once

#include <array>
#include <optional>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Solid fraction of every grain by Voronoi cells (Bierwisch 2009, section 2.6; walls cut on the wall spheres' surface).
/// `period`: periodic lengths along x and y in m, if any.
results::GrainSolidFraction measure_solid_fraction(const results::PowderState& powder,
                                                   const std::vector<results::ToolState>& tools,
                                                   const results::CavityState& cavity,
                                                   const std::array<std::optional<double>, 2>& period);

/// Mean (sum of solid volumes over sum of cell volumes, and arithmetic), standard deviation, range and coefficient of
/// variation over closed cells in the cavity at least 2 d below the powder surface (OP-11).
results::SolidFractionSummary summarise(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                                        const results::CavityState& cavity);

/// Solid fraction over azimuth (deg, 0 where the shoe arrives first) and height (mm above the cavity floor) of a ring,
/// averaged over the radius, Gaussian width `averaging_width` (m) (Bierwisch 2009, Eq. 2.27).
results::Field2D cylindrical_map(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                                 const results::CavityState& cavity, double averaging_width);

/// Solid fraction in a plane (Eq. 2.27); NaN where no powder is within reach or a tool's solid lies.
results::SectionField plane_section(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                                    const std::vector<results::ToolState>& tools, const results::SectionPlane& plane,
                                    double averaging_width);

/// Height (mm above the cavity floor) of the powder surface against azimuth (deg) in `bins` bins; rings only.
results::Profile fill_level(const results::PowderState& powder, const results::CavityState& cavity, int bins);

/// Mass (kg) of the grains whose centre lies in the cavity.
double filled_mass(const results::PowderState& powder, const results::GrainSolidFraction& fraction);

}  // namespace diefill::process
