// How far simulated points lie from a measured curve: perpendicular distance in scaled coordinates, so that a
// steep curve does not make a small error in x look large (Bierwisch 2009, Eqs. 4.3 and 4.4).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process::calibration {

/// A measured curve as points in rising order of x, straight lines between them. Both coordinates are divided
/// by their scale before distances are taken.
struct MeasuredCurve {
  std::vector<double> x, y;
  double x_scale = 1, y_scale = 1;  ///< in the source the largest speed and the largest area
};

/// The curve with the scales of the source: its largest |x| and |y|. Throws std::invalid_argument for fewer
/// than two points, for x that does not rise, and where a scale is zero.
MeasuredCurve curve_through(std::vector<double> x, std::vector<double> y);

/// delta_i, the shortest distance of a point from the curve (Eq. 4.4). Beyond the ends it is the distance
/// from the end point.
double distance_from(const MeasuredCurve& curve, double x, double y);

/// epsilon^2, the mean of the squared distances of the points (x[k], y[k]) (Eq. 4.3).
double mean_square_residual(const MeasuredCurve& curve, const std::vector<double>& x,
                            const std::vector<double>& y);

/// Name, unit and nodes of one axis of a map.
struct MapAxis {
  std::string name, unit;
  std::vector<double> nodes;
};

/// A residual at every node of two parameters.
results::Field2D residual_map(const std::string& quantity, const MapAxis& first, const MapAxis& second,
                              const std::function<double(double, double)>& residual);

}  // namespace diefill::process::calibration
