// The largest shoe speed that fills a die, from runs at several speeds.
#pragma once

#include <string>
#include <vector>

namespace diefill::render::report {

/// Fill ratio delta over shoe speed v follows delta = (v_c / v)^n beyond the critical speed v_c (Sinka,
/// Schneider and Cocks 2004, International Journal of Pharmaceutics 280).
struct CriticalSpeed {
  double speed = 0;     ///< m/s, v_c; NaN where it cannot be determined
  double exponent = 0;  ///< n
  int points = 0;       ///< incompletely filled runs that it comes from
  /// m/s, ends of the 95 % interval; NaN where neither residuals nor scatter over seeds determine them.
  double lower = 0, upper = 0;
  double fastest_full = 0, slowest_incomplete = 0;  ///< m/s, of the runs; NaN where there is none
  double extrapolation = 1;  ///< how many times v_c lies beyond the speeds that were run; 1: among them
  bool too_far = false;      ///< by more than kFarthest: speed and interval are not given
};

/// The farthest that v_c is extrapolated below the slowest or above the fastest run.
inline constexpr double kFarthest = 2;

/// Least squares in logarithms over the speeds (m/s) at which a die does not count as full
/// (results/full_die.h). `error`: standard errors of the fill ratios, from several seeds; empty or NaN where
/// not known. The interval is that of the zero of the fitted line, from the residuals of three runs or more
/// or from `error`, whichever is wider. Speed and exponent are NaN where fewer than two speeds filled
/// incompletely, or fill ratio does not fall with speed.
CriticalSpeed critical_speed(const std::vector<double>& speed, const std::vector<double>& fill_ratio,
                             const std::vector<double>& error = {});

/// The result in sentences.
std::string description(const CriticalSpeed& critical);

}  // namespace diefill::render::report
