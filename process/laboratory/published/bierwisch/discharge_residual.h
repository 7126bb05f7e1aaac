// How far discharges of the moving shoe are from the measured curve (Bierwisch 2009, Eqs. 4.1, 4.3 and 4.4).
#pragma once

#include <vector>

namespace diefill::process::laboratory {

/// What one passage discharged.
struct PassagePoint {
  double speed = 0;  ///< m/s
  double area = 0;   ///< m^2
};

/// epsilon^2 of Eq. 4.3 for a slit of `width` (m): mean of the squared distances from the measured curve
/// between 0.1 and 0.8 m/s, speeds over 0.8 m/s and areas over the largest one of that curve.
double discharge_residual(const std::vector<PassagePoint>& points, double width);

/// Largest deviation of a point from the measured curve, over what agrees: 10 % of it, or 2 mm^2 where that
/// is more.
double largest_deviation(const std::vector<PassagePoint>& points, double width);

}  // namespace diefill::process::laboratory
