// The smooth start and stop of motions, from 0 to 1: value, velocity and acceleration are continuous.
#pragma once

#include <algorithm>
#include <limits>

namespace diefill::process {

/// 6 x^5 - 15 x^4 + 10 x^3 of x in [0, 1], 0 before and 1 after: slope and curvature vanish at both ends.
inline double ramp_value(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * x * (x * (6 * x - 15) + 10);
}

/// Its derivative.
inline double ramp_slope(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return 30 * x * x * (x - 1) * (x - 1);
}

/// Its integral from 0; grows as x - 1/2 beyond 1.
inline double ramp_integral(double x) {
  if (x >= 1) return x - 0.5;
  x = std::max(x, 0.0);
  return x * x * x * x * (x * (x - 3) + 2.5);
}

/// Amplitude over time of a motion that ramps up, continues and ramps down.
class Envelope {
 public:
  /// `ramp` s of each ramp (0: at once); `end` s when the motion is over, infinite if never. The ramps do not
  /// overlap: an end before two ramps have passed is postponed to then.
  explicit Envelope(double ramp, double end = std::numeric_limits<double>::infinity())
      : ramp_(ramp), end_(std::max(end, 2 * ramp)) {}

  double end() const { return end_; }  ///< s
  double value(double time) const;     ///< from 0 to 1
  double slope(double time) const;     ///< 1/s, derivative of value
  double integral(double time) const;  ///< s, integral of value from 0

 private:
  double ramp_, end_;
};

}  // namespace diefill::process
