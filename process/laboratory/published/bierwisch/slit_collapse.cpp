#include "process/laboratory/published/bierwisch/slit_collapse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "process/measure/figures/line_fit.h"
#include "process/powder/empty_annulus.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kMin = 4;                              // points
constexpr double kOffsetWithin = 0.3, kSpreadWithin = 0.05;  // d; of the rate

}  // namespace

SlitOffset fitted_offset(const SlitPoints& points) {
  const auto count = static_cast<Eigen::Index>(points.rate.size());
  if (count < 4) return {};
  Eigen::MatrixX2d places(count, 2);
  Eigen::VectorXd root(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    if (!std::isfinite(points.rate[n])) return {};
    places.row(k) << points.width[n], points.diameter[n];
    root[k] = std::pow(points.rate[n], 2.0 / 3);
  }
  const Eigen::Matrix2d normal = places.transpose() * places;
  const Eigen::Vector2d slopes = normal.ldlt().solve(places.transpose() * root);
  const double variance = (places * slopes - root).squaredNorm() / static_cast<double>(count - 2);
  const Eigen::Matrix2d covariance = variance * normal.inverse();
  const double offset = -slopes[1] / slopes[0];
  const Eigen::Vector2d gradient(-offset / slopes[0], -1 / slopes[0]);
  return {offset, std::sqrt(gradient.dot(covariance * gradient))};
}

double spread_about_one_curve(const SlitPoints& points) {
  const std::size_t count = points.rate.size();
  std::vector<double> opening, rate;
  for (std::size_t k = 0; k < count; ++k) {
    opening.push_back(std::log(points.width[k] - kEmptyAnnulus * points.diameter[k]));
    rate.push_back(std::log(points.rate[k]));
    if (!std::isfinite(opening[k] + rate[k])) return std::nan("");
  }
  if (count < kMin) return std::nan("");
  const FittedLine line = fit_line(opening, rate);
  double squares = 0;
  for (std::size_t k = 0; k < count; ++k) squares += std::pow(rate[k] - line.at(opening[k]), 2);
  return std::sqrt(squares / static_cast<double>(count - 2));
}

double lack_of_slit_collapse(const SlitPoints& points) {
  const double offset = std::abs(fitted_offset(points).value - kEmptyAnnulus) / kOffsetWithin,
               spread = spread_about_one_curve(points) / kSpreadWithin;
  return std::isfinite(offset + spread) ? std::max(offset, spread) : std::nan("");
}

}  // namespace diefill::process::laboratory
