// The scaled-up particle model, "SUP" (Hu 2024, chapter 3; Method 1 of chapters 4 to 6).
#pragma once

#include "engine/coarse_graining/force_scaling.h"

namespace diefill::engine::coarse_graining {

/// Contact force, attraction and torque all grow with l^2, overlaps and gaps with l, so that stresses stay
/// the same (Hu 2024, Eqs. 3.21 to 3.45).
inline ForceScaling scaled_up_particle(double scale) {
  return {.scale = scale, .force_exponent = 2, .attraction_exponent = 2, .torque_exponent = 2};
}

}  // namespace diefill::engine::coarse_graining
