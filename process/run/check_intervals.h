// Intervals of a run's periodic tasks, in time steps. Tasks are due at multiples of their interval, so that a
// resumed run does them at the same steps as an uninterrupted one.
#pragma once

#include <cstdint>

namespace diefill::process {

inline constexpr std::uint64_t kScheduleInterval = 20;    ///< update of the schedule
inline constexpr std::uint64_t kPinchInterval = 10;       ///< check for grains pinched between tools
inline constexpr std::uint64_t kSpillInterval = 100;      ///< removal of spilled grains
inline constexpr std::uint64_t kFeedInterval = 100;       ///< powder inflow
inline constexpr std::uint64_t kValidityInterval = 200;   ///< check of the method's limits
inline constexpr std::uint64_t kLostGrainInterval = 200;  ///< check for grains inside tools
inline constexpr std::uint64_t kForcedToolInterval =
    100;  ///< check of force-controlled and free tools for collisions

/// Update of contacts from another engine (step_engine.h) for checks that need them. The search for near
/// pairs takes as long as some ten steps, and one rank does it alone.
inline constexpr std::uint64_t kContactSyncInterval = 2000;

}  // namespace diefill::process
