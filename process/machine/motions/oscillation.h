// An oscillation in time of any quantity: e(t) A sin(2 pi f t + phi) with an envelope e that ramps up
// and down (Bierwisch 2009, Eq. 6.1 and section 6.5.2).
#pragma once

#include <vector>

#include "process/machine/motions/ramped_motion.h"

namespace diefill::process {

/// SI units.
struct Oscillation {
  double amplitude = 0;  ///< m or rad
  double frequency = 0;  ///< Hz
  double phase = 0;      ///< rad
  RampTimes ramps;

  double value(double time, const Envelope& envelope) const;  ///< m or rad
  double rate(double time, const Envelope& envelope) const;   ///< m/s or rad/s
  /// s: of an oscillation that lasts `length` s, the first instant at full amplitude and one half a period
  /// later, on the other side; fewer where it ends before.
  std::vector<double> turning_points(double length) const;
};

/// Reads `amplitude` by `rule`, `frequency`, `phase`, `ramp` (one period unless given) and `duration`. Throws
/// SceneError.
Oscillation read_oscillation(TableReader& table, const QuantityRule& rule);

}  // namespace diefill::process
