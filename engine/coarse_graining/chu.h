// Coarse graining after Chu et al. (as set out in Hu 2024, chapter 5).
#pragma once

#include "engine/coarse_graining/force_scaling.h"

namespace diefill::engine::coarse_graining {

/// Contact forces grow with l^2, torques with l^3, at unscaled overlap. The source gives no rule for
/// attraction; it follows the contact forces here.
inline ForceScaling chu(double scale) {
  return {.scale = scale,
          .force_exponent = 2,
          .attraction_exponent = 2,
          .torque_exponent = 3,
          .overlap_exponent = 0,
          .gap_exponent = 0,
          .spring_exponent = 0};
}

}  // namespace diefill::engine::coarse_graining
