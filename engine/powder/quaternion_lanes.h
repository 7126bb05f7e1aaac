// Orientations for loops that vector instructions work on.
#pragma once

#include "engine/numerics/lanes.h"
#include "engine/powder/rigid_motion.h"

namespace diefill::engine {

/// One quaternion a lane.
template <std::size_t kCount>
struct QuaternionLanes {
  Lanes<kCount> w, x, y, z;
  PlainQuaternion operator[](std::size_t lane) const { return {w[lane], x[lane], y[lane], z[lane]}; }
  void set(std::size_t lane, PlainQuaternion q) {
    w[lane] = q.w;
    x[lane] = q.x;
    y[lane] = q.y;
    z[lane] = q.z;
  }
};

}  // namespace diefill::engine
