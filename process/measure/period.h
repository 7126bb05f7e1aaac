// Periodic lengths as geometry takes them.
#pragma once

#include <array>
#include <optional>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Periodic lengths in m, box centred on the origin.
using Period = std::array<std::optional<double>, 3>;

inline Period period_of(const results::PowderState& powder) {
  Period period;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (powder.period[axis] > 0) period[axis] = powder.period[axis];
  return period;
}

}  // namespace diefill::process
