// Measures a filled die: solid fraction per grain, Gaussian-averaged fields, filled mass, fill level.
// Works on results alone, so that every figure can be made again later without simulating.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Solid fraction of every grain by Voronoi cells (Bierwisch 2009, section 2.6; walls cut on the wall
/// spheres' surface). A cell is open where it would reach farther than the largest d from one of its spheres'
/// centres. Solid fraction of a grain without any cell is 0, and its cell open.
results::GrainSolidFraction measure_solid_fraction(const results::PowderState& powder,
                                                   const std::vector<results::ToolState>& tools,
                                                   const results::CavityState& cavity);

/// Mean (sum of solid volumes over sum of cell volumes, and arithmetic), standard deviation (over all, not of
/// a sample), range and coefficient of variation over closed cells in the cavity at least 2 d below the
/// powder surface (OP-11). The surface over a grain is the highest grain centre within d of it horizontally.
/// All NaN where no grain counts.
results::SolidFractionSummary summarise(const results::PowderState& powder,
                                        const results::GrainSolidFraction& fraction,
                                        const results::CavityState& cavity);

/// Solid fraction over azimuth (deg from 0, where the shoe arrives first, to 360, counter-clockwise seen from
/// above) and height (mm above the cavity floor, to the fill plane, and on where powder is heaped) of a ring.
/// Mean over the radius, weighted by radius, of Eq. 2.27 (Bierwisch 2009) with Gaussian width
/// `averaging_width` (m). Only closed cells enter. NaN where no such grain's centre is within the larger
/// of 1.2 d and 1.5 sigma at any radius: holes stay holes. Radii inside the tools' solids, as under the step
/// of a stepped ring, do not count. Nodes are 2 deg (finer for large rings) and about sigma / 2 apart. Throws
/// std::invalid_argument for other cavities.
results::Field2D cylindrical_map(const results::PowderState& powder,
                                 const results::GrainSolidFraction& fraction,
                                 const std::vector<results::ToolState>& tools,
                                 const results::CavityState& cavity, double averaging_width);

/// Solid fraction in a plane (Eq. 2.27) over the extent of the powder in the cavity (of all powder if none is
/// there) and 2 d more; NaN as above, inside the tools' solids and in clearances between them below R / 2. No
/// nodes where no powder is near. Nodes are sigma / 5 apart, or more for at most 400 along the longer side.
results::SectionField plane_section(const results::PowderState& powder,
                                    const results::GrainSolidFraction& fraction,
                                    const std::vector<results::ToolState>& tools,
                                    const results::SectionPlane& plane, double averaging_width);

/// Height (mm above the cavity floor) of the powder surface against azimuth (deg, middle of the bin) in
/// `bins` bins: the top of the highest sphere whose centre lies between the ring's radii, NaN for an empty
/// bin. Sphere tops, so that powder struck off level with the die reads as full whatever its grain size.
/// Throws std::invalid_argument for no ring.
results::Profile fill_level(const results::PowderState& powder, const results::CavityState& cavity, int bins);

/// Mass (kg) of the grains whose centre lies in the cavity.
double filled_mass(const results::PowderState& powder, const results::GrainSolidFraction& fraction);

/// Sum of solid volumes over sum of cell volumes of all closed cells at least 2 d below the powder surface,
/// in the cavity or not; NaN if there are none.
double bulk_solid_fraction(const results::PowderState& powder, const results::GrainSolidFraction& fraction);

/// Share of a ring that solid fills, over azimuth (deg, middle of the sector) in `sectors` equal sectors:
/// solid volume of the grains whose centre lies in the sector over the sector's part of the cavity's volume.
/// Counts missing powder as well as loose powder. Throws std::invalid_argument for other cavities.
results::Profile sector_filling(const results::PowderState& powder,
                                const results::GrainSolidFraction& fraction,
                                const results::CavityState& cavity, int sectors);

/// Mean of a map over its first coordinate where it has values, against its second; NaN where fewer than half
/// of the nodes have one. Takes a map that ends where it began (azimuth 0 and 360 deg) once.
results::Profile height_profile(const results::Field2D& map);

/// Largest less smallest over the mean of a profile's values; NaN where it has none.
double relative_range(const results::Profile& profile);

}  // namespace diefill::process
