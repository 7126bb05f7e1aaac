#include "process/calibration/methods/space_filling.h"

#include <boost/random/sobol.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

namespace diefill::process::calibration {

Eigen::MatrixXd space_filling(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  if (dimensions == 0) throw std::invalid_argument("a set of points has one dimension or more");
  std::mt19937_64 random(seed);
  Eigen::RowVectorXd offset(static_cast<Eigen::Index>(dimensions));
  for (double& shift : offset) shift = static_cast<double>(random() >> 11U) * 0x1p-53;
  boost::random::sobol sequence(dimensions);
  Eigen::MatrixXd points(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(dimensions));
  for (Eigen::Index k = 0; k < points.rows(); ++k)
    for (Eigen::Index d = 0; d < points.cols(); ++d) {
      const double value = static_cast<double>(sequence() >> 11U) * 0x1p-53 + offset[d];
      points(k, d) = value - std::floor(value);
    }
  return points;
}

}  // namespace diefill::process::calibration
