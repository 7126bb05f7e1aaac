#include "process/estimate/filling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::process::estimate {

namespace {

double slows_below(const Room& room) {
  return std::min(room.depth, kSlowsBelow * room.width);
}

}  // namespace

double filled_height(const Room& room, double offered) {
  const double reach = slows_below(room), free = room.depth - reach;
  if (offered <= free) return offered;
  if (!(reach > 0)) return room.depth;
  return room.depth - reach * std::exp(-(offered - free) / reach);
}

double offered_for(const Room& room, double height) {
  const double reach = slows_below(room), free = room.depth - reach;
  if (height <= free) return height;
  if (height >= room.depth) return std::numeric_limits<double>::infinity();
  return free - reach * std::log((room.depth - height) / reach);
}

}  // namespace diefill::process::estimate
