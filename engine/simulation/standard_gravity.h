// The acceleration of gravity where none is given.
#pragma once

namespace diefill::engine {

/// m/s^2
inline constexpr double kStandardGravity = 9.81;

}  // namespace diefill::engine
