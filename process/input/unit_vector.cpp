#include "process/input/unit_vector.h"

namespace diefill::process {

std::optional<Eigen::Vector3d> unit_vector(const Eigen::Vector3d& given) {
  const double largest = given.cwiseAbs().maxCoeff();
  if (!given.allFinite() || largest < kShortestDirection || largest > kLongestDirection) return std::nullopt;
  return given.stableNormalized();
}

}  // namespace diefill::process
