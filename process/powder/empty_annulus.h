// How much of an opening coarse grains leave empty along its edge.
#pragma once

namespace diefill::process {

/// An opening acts as if narrower by this many grain diameters (Bierwisch 2009, section 3.2.2).
inline constexpr double kEmptyAnnulus = 1.4;

}  // namespace diefill::process
