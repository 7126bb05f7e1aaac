// Points that fill the unit cube evenly, to start a search from.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace diefill::process::calibration {

/// `count` points, one per row, in [0, 1)^dimensions: Sobol's sequence (Joe and Kuo's directions, from
/// Boost), moved round the cube by an offset that `seed` gives (Cranley and Patterson 1976), so that seeds
/// give different sets of the same evenness. The first points of a longer set are those of a shorter one.
/// Throws std::invalid_argument for no dimensions.
Eigen::MatrixXd space_filling(std::size_t count, std::size_t dimensions, std::uint64_t seed);

}  // namespace diefill::process::calibration
