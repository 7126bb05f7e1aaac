// The straight line of least squares through points of a plane.
#pragma once

#include <limits>
#include <vector>

namespace diefill::process {

/// y = level + slope x; all NaN where the points do not determine it.
struct FittedLine {
  double level = std::numeric_limits<double>::quiet_NaN();
  double slope = level;
  double r_squared = level;  ///< share of the scatter of y that the line accounts for

  double at(double x) const { return level + slope * x; }
};

/// Of at least two points with different `x`; every point counts alike.
FittedLine fit_line(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace diefill::process
