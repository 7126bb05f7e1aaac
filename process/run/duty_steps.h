// When a run checks its powder, removes grains and follows its schedule. Duties fall on multiples of these
// steps, so that a restart does them when the unbroken run does.
#pragma once

#include <cstdint>

namespace diefill::process {

inline constexpr std::uint64_t kScheduleEvery = 20, kSpillEvery = 100, kFeedEvery = 100,
                               kValidityCheckEvery = 200, kPinchEvery = 10, kLostEvery = 200,
                               kForcedEvery = 100;
/// When another engine shows contacts (step_engine.h), for checks that ask for them: finding near pairs again
/// takes the time of some ten steps, and one rank does it alone.
inline constexpr std::uint64_t kContactsEvery = 2000;

}  // namespace diefill::process
