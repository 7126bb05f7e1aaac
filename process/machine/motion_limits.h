// How far, how fast and how long motions of scenes may be, as a scene writes it: beyond these a unit is
// wrong.
#pragma once

#include <string_view>

namespace diefill::process::motion_limits {

inline constexpr std::string_view kFarthest = "10 m", kFarthestBack = "-10 m";
inline constexpr std::string_view kFastest = "10 m/s";
inline constexpr std::string_view kFastestTurn = "60000 rpm", kFastestTurnBack = "-60000 rpm";
inline constexpr std::string_view kLongest = "1000 s";

}  // namespace diefill::process::motion_limits
