// Compressibility and stiffness from the curve of a bed that is pressed in cycles (Kottlan 2018,
// section 2.7.2).
#pragma once

#include <limits>
#include <vector>

namespace diefill::process::laboratory {

/// Height of the bed (m) and stress on it (Pa) in order of time, from the first resistance on.
struct LoadCurve {
  std::vector<double> height, stress;
};

/// Loads (Pa) between which the bed is cycled; stiffnesses are those of chords to the half load.
struct LoadCycle {
  double high = 15e3, low = 500, half = 7.5e3;
  int cycles = 5;
};

/// NaN where the curve ends before.
struct Stiffness {
  double beta = std::numeric_limits<double>::quiet_NaN();       ///< (h_0 - h_1) / h_0, first loading
  double loading = std::numeric_limits<double>::quiet_NaN();    ///< Pa, low to half load
  double unloading = std::numeric_limits<double>::quiet_NaN();  ///< Pa, high to half load
};

/// Means over the cycles (Eqs. 31 to 33), strain over h_1. Loads count as reached within 1 %.
Stiffness stiffness_of(const LoadCurve& curve, const LoadCycle& loads);

/// A plate that is pulled off: its travel (m) and the pull of the bed on it (N), in order of time.
struct PullCurve {
  std::vector<double> travel, pull;
};

/// What the curve says; NaN where it has fewer than 20 rows.
struct Tension {
  double strength = std::numeric_limits<double>::quiet_NaN();  ///< N, peak less what stays on the plate
  /// m, from the peak to where the pull has fallen to a tenth of the strength for good.
  double fracture = std::numeric_limits<double>::quiet_NaN();
};

/// The weight of what stays is the mean over the last twentieth of the rows (Kottlan 2018, section 2.7.3).
Tension tension_of(const PullCurve& curve);

}  // namespace diefill::process::laboratory
