// Probability density of the speeds of grains over the last part of a run (Hu 2024, section 4.3).
#pragma once

#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

struct SpeedDensity {
  std::vector<double> speed, density;  ///< m/s in the middle of a bin, s/m
  double mean = 0;                     ///< m/s, of all speeds

  double peak() const;  ///< m/s, where the density, as the mean of three bins, is largest
  /// Coefficient of determination of the straight line through the density up to a speed (m/s).
  double linearity(double up_to) const;
};

/// From 0 to 1.5 m/s in bins of 0.05 m/s, over the instants of the last `seconds` before `end`. Throws
/// results::ResultError where there are none.
SpeedDensity speed_density(const results::FillResult& result, double end, double seconds);

/// Integral of the absolute difference of two densities, 0 to 2.
double difference(const SpeedDensity& one, const SpeedDensity& other);

}  // namespace diefill::process::laboratory
