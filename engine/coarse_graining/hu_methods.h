// The alternatives that Hu 2024 compares with the scaled-up particle model (Tables 4.1, 5.1).
#pragma once

#include "engine/coarse_graining/force_scaling.h"

namespace diefill::engine::coarse_graining {

/// Chapter 4, Method 2: scaled forces, but unscaled overlaps and gaps. Springs become l^(3/2) times stiffer
/// and the range of attraction too short.
inline ForceScaling hu_chapter_4_method_2(double scale) {
  return {.scale = scale,
          .force_exponent = 2,
          .attraction_exponent = 2,
          .torque_exponent = 2,
          .overlap_exponent = 0,
          .gap_exponent = 0,
          .spring_exponent = 0};
}

/// Chapter 4, Method 3: forces and torques grow with the mass, l^3.
inline ForceScaling hu_chapter_4_method_3(double scale) {
  return {.scale = scale, .force_exponent = 3, .attraction_exponent = 3, .torque_exponent = 3};
}

/// Chapters 5 and 6, Method 2: forces with l^2, torques with l^3, which is exact geometric similarity; not
/// the Method 2 of chapter 4. Overlaps geometrically similar, which those chapters leave open.
inline ForceScaling hu_chapter_5_method_2(double scale) {
  return {.scale = scale, .force_exponent = 2, .attraction_exponent = 2, .torque_exponent = 3};
}

/// Chapters 5 and 6, Method 3: all with l^3. Overlaps geometrically similar, which those chapters leave open.
inline ForceScaling hu_chapter_5_method_3(double scale) {
  return {.scale = scale, .force_exponent = 3, .attraction_exponent = 3, .torque_exponent = 3};
}

}  // namespace diefill::engine::coarse_graining
