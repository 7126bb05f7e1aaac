#include "process/input/unit_vector.h"

namespace diefill::process {

std::optional<Eigen::Vector3d> unit_vector(const Eigen::Vector3d& given) {
  const double largest = given.cwiseAbs().maxCoeff();
  if (!given.allFinite() || largest < kShortestDirection || largest > kLongestDirection) return std::nullopt;
  return given.stableNormalized();
}

std::optional<Eigen::Vector3d> axis_called(const std::string& word) {
  const bool negative = word.starts_with('-');
  const std::string axis = word.substr(negative || word.starts_with('+') ? 1 : 0);
  const std::size_t index = axis.size() == 1 ? std::string("xyz").find(axis) : std::string::npos;
  if (index == std::string::npos) return std::nullopt;
  return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(index)) * (negative ? -1.0 : 1.0);
}

}  // namespace diefill::process
