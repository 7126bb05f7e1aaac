// Coarse graining after Sakai and Koshizuka 2009 (Hu 2024, Eqs. 3.5 to 3.7).
#pragma once

#include "engine/coarse_graining/force_scaling.h"

namespace diefill::engine::coarse_graining {

/// A large grain represents l^3 small ones that move together: contact forces grow with l^3 at unscaled
/// overlap, van der Waals attraction with l^2, torques are force times the large radius.
inline ForceScaling sakai_koshizuka(double scale) {
  return {.scale = scale,
          .force_exponent = 3,
          .attraction_exponent = 2,
          .torque_exponent = 4,
          .overlap_exponent = 0,
          .gap_exponent = 0,
          .spring_exponent = 0};
}

}  // namespace diefill::engine::coarse_graining
