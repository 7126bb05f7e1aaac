// The shoe speed up to which a die fills, from runs at several speeds.
#pragma once

#include <vector>

namespace diefill::render::report {

/// Fill ratio delta over shoe speed v follows delta = (v_c / v)^n beyond the critical speed v_c (Sinka,
/// Schneider and Cocks 2004, International Journal of Pharmaceutics 280).
struct CriticalSpeed {
  double speed = 0;     ///< m/s, v_c
  double exponent = 0;  ///< n
  int points = 0;       ///< incompletely filled runs that it comes from
};

/// Least squares in logarithms over the speeds (m/s) whose fill ratio is below `complete`. Speed and exponent
/// are NaN where fewer than two speeds filled incompletely, or fill ratio does not fall with speed.
CriticalSpeed critical_speed(const std::vector<double>& speed, const std::vector<double>& fill_ratio,
                             double complete = 0.98);

}  // namespace diefill::render::report
