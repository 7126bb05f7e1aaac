// Since when the powder has been at rest while the schedule waits for a mass or a force.
#pragma once

#include "process/tooling/rest.h"

namespace diefill::process {

/// A plain value, so that a checkpoint can keep it.
struct Standstill {
  RestWatch rest;
  double since = -1;  ///< s; negative: something still moves, comes in, or will as time passes

  /// Whether this has lasted so long by `now` (s) that it stays so.
  bool lasts(double now) const {
    constexpr double kLongestRest = 0.2;  // s at rest, after which nothing more is expected
    return since >= 0 && now - since >= kLongestRest;
  }
};

}  // namespace diefill::process
