// Where powder in a ring moves and densifies between two instants of a filling (Bierwisch 2009, section 6.4).
// The ring is about the z axis, its upper edge at z = 0; azimuth 0 is at +x.
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct RingSpace {
  double inner, outer, depth;  ///< m
};

/// Solid volume of the grains below the upper edge, m^3, by centres; within 90 deg of azimuth 0 alone if
/// wanted.
double filled_volume(const results::PowderState& powder, bool near_start = false);

/// Share of the change of solid volume over cells (12 sectors, layers of d) that lies no deeper than 3 d
/// below the powder's level in the sector, the lower one of both instants. The level is that of powder of
/// solid fraction 0.35. NaN where nothing changes.
double change_near_surface(const results::PowderState& before, const results::PowderState& after,
                           const RingSpace& ring);

/// Of the grains that are in the ring at both instants, the share that has moved by half a diameter: layer by
/// layer of d from the upper edge down; NaN where there are none.
std::vector<double> moved_shares(const results::PowderState& before, const results::PowderState& after,
                                 const RingSpace& ring);

/// m, depth down to which, layer by layer, a tenth of the grains have moved (moved_shares).
double depth_of_motion(const results::PowderState& before, const results::PowderState& after,
                       const RingSpace& ring);

/// d, mean displacement of the grains that are in the ring at both instants; NaN without any.
double mean_motion(const results::PowderState& before, const results::PowderState& after);

}  // namespace diefill::process::laboratory
