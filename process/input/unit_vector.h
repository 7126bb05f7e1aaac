// A direction that someone gave as three numbers or as an axis, as a vector of length 1.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace diefill::process {

/// Between them the largest of three numbers has to be; beyond, digits are lost or squares overflow.
inline constexpr double kShortestDirection = 1e-100, kLongestDirection = 1e100;

/// The unit vector along `given`; nothing where that is not finite or outside this range.
std::optional<Eigen::Vector3d> unit_vector(const Eigen::Vector3d& given);

/// That along "x", "+x" or "-x", and so on; nothing for other words.
std::optional<Eigen::Vector3d> axis_called(const std::string& word);

}  // namespace diefill::process
