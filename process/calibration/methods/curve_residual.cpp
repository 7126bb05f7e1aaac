#include "process/calibration/methods/curve_residual.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace diefill::process::calibration {
namespace {

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

MeasuredCurve curve_through(std::vector<double> x, std::vector<double> y) {
  if (x.size() < 2 || x.size() != y.size())
    throw std::invalid_argument("a measured curve has two points or more");
  for (std::size_t k = 1; k < x.size(); ++k)
    if (!(x[k] > x[k - 1])) throw std::invalid_argument("the points of a measured curve have rising x");
  const double x_scale = largest(x), y_scale = largest(y);
  if (!(x_scale > 0) || !(y_scale > 0))
    throw std::invalid_argument("a measured curve that is zero everywhere has no scale");
  return {std::move(x), std::move(y), x_scale, y_scale};
}

double distance_from(const MeasuredCurve& curve, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < curve.x.size(); ++k) {
    const double along_x = (curve.x[k] - curve.x[k - 1]) / curve.x_scale,
                 along_y = (curve.y[k] - curve.y[k - 1]) / curve.y_scale;
    const double from_x = (x - curve.x[k - 1]) / curve.x_scale, from_y = (y - curve.y[k - 1]) / curve.y_scale;
    const double share =
        std::clamp((from_x * along_x + from_y * along_y) / (along_x * along_x + along_y * along_y), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(from_x - share * along_x, from_y - share * along_y));
  }
  return nearest;
}

double mean_square_residual(const MeasuredCurve& curve, const std::vector<double>& x,
                            const std::vector<double>& y) {
  if (x.empty() || x.size() != y.size()) throw std::invalid_argument("a residual needs simulated points");
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += std::pow(distance_from(curve, x[k], y[k]), 2);
  return sum / static_cast<double>(x.size());
}

results::Field2D residual_map(const std::string& quantity, const MapAxis& first, const MapAxis& second,
                              const std::function<double(double, double)>& residual) {
  results::Field2D map;
  map.quantity = quantity;
  map.first_name = first.name;
  map.first_unit = first.unit;
  map.second_name = second.name;
  map.second_unit = second.unit;
  map.first = first.nodes;
  map.second = second.nodes;
  for (const double b : second.nodes)
    for (const double a : first.nodes) map.value.push_back(residual(a, b));
  return map;
}

}  // namespace diefill::process::calibration
