// Rounding in the tests that leave out pairs and bodies that are too far apart to touch.
#pragma once

namespace diefill::engine {

/// Factor on how far grains have moved or may reach: larger than the rounding of places, of distances kept as
/// float and of sums over many steps, so that none of these makes a pair seem farther apart than it is.
inline constexpr double kDistanceRounding = 1 + 1e-6;

}  // namespace diefill::engine
