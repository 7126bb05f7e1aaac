// The hopper that follows from the published shear test of the powder of the hopper.
#pragma once

#include "process/continuum/wedge_hopper.h"

namespace diefill::process::laboratory {

/// Jenike's design from the predicted shear test (Kottlan 2018, section 3.4 and Table 15), wall angle
/// measured.
continuum::WedgeHopper published_hopper();

}  // namespace diefill::process::laboratory
